/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause */
#define _POSIX_C_SOURCE 200809L
#include "depth_sender.h"

#include <errno.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <time.h>
#include <unistd.h>

static const uint32_t kBytes[] = {0, 2, 4, 12}; /* of a number or point, by format */

tern_depth_header tern_depth_camera(uint32_t format, uint32_t width, uint32_t height, double fx, double fy, double cx,
                                    double cy) {
  tern_depth_header h = {TERN_DEPTH_MAGIC,
                         TERN_DEPTH_VERSION,
                         sizeof(tern_depth_header),
                         0,
                         format,
                         0,
                         width,
                         height,
                         0,
                         0,
                         fx,
                         fy,
                         cx,
                         cy,
                         0.2,
                         20.0,
                         {0, 0, 0},
                         {0.5, -0.5, 0.5, -0.5}};
  if (format < sizeof kBytes / sizeof *kBytes) h.payload_bytes = width * height * kBytes[format];
  return h;
}

int64_t tern_depth_now(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return 1000000000 * (int64_t)now.tv_sec + now.tv_nsec;
}

int tern_depth_connect(const char* path) {
  struct sockaddr_un to = {.sun_family = AF_UNIX};
  const int connection = socket(AF_UNIX, SOCK_STREAM, 0);
  if (strlen(path) >= sizeof to.sun_path) {
    errno = ENAMETOOLONG;
  } else {
    strcpy(to.sun_path, path);
    if (connection >= 0 && connect(connection, (const struct sockaddr*)&to, sizeof to) == 0) return connection;
  }
  if (connection >= 0) close(connection);
  return -1;
}

static int send_all(int connection, const void* bytes, size_t count) {
  const char* at = bytes;
  while (count > 0) {
    const ssize_t sent = send(connection, at, count, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return -1;
    at += sent;
    count -= (size_t)sent;
  }
  return 0;
}

int tern_depth_send(int connection, const tern_depth_header* header, const void* payload) {
  if (send_all(connection, header, sizeof *header) != 0) return -1;
  return send_all(connection, payload, header->payload_bytes);
}

void tern_depth_close(int connection) {
  close(connection);
}
