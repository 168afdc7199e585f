/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Sends frames of depth to tern_companion. C99 and POSIX. */
#ifndef TERN_DEPTH_SENDER_H
#define TERN_DEPTH_SENDER_H

#include "depth_format.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A header for a camera that looks ahead, level and at the body's centre. Change what differs. */
tern_depth_header tern_depth_camera(uint32_t format, uint32_t width, uint32_t height, double fx, double fy, double cx,
                                    double cy);
/* Now, on the clock of tern_depth_header::stamp_ns. */
int64_t tern_depth_now(void);
/* Connects to the companion's socket. A descriptor for the next two, or -1 with errno. */
int tern_depth_connect(const char* path);
/* Sends one frame, and waits until it is handed over. 0; or -1 with errno: close and connect again. */
int tern_depth_send(int connection, const tern_depth_header* header, const void* payload);
void tern_depth_close(int connection);

#ifdef __cplusplus
} /* extern "C" */
#endif

#endif
