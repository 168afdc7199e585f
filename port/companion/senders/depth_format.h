/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Frames of depth for tern_companion, over a UNIX stream socket: this header, then the payload, again and again. One
 * connection may carry frames of several sensors. Numbers are little-endian; nothing lies between the fields. */
#ifndef TERN_DEPTH_FORMAT_H
#define TERN_DEPTH_FORMAT_H

#include <stdint.h>

#define TERN_DEPTH_MAGIC 0x4E524554u /* the bytes "TERN" */
#define TERN_DEPTH_VERSION 1
#define TERN_DEPTH_MOST_BYTES 33554432u /* of a payload */

enum {
  TERN_DEPTH_MILLIMETRES = 1, /* rows of uint16: depth along the optical axis; 0 and 65535 are no measurement */
  TERN_DEPTH_METRES = 2,      /* rows of float: likewise; 0 and NaN are no measurement */
  TERN_DEPTH_POINTS = 3       /* three floats a point: x, y, z in the sensor's axes, m. NaN: a beam without an answer */
};

typedef struct {
  uint32_t magic;
  uint16_t version;
  uint16_t header_bytes;  /* sizeof(tern_depth_header) */
  uint32_t sensor;        /* which one: 0 .. 7 */
  uint32_t format;        /* one of the above */
  int64_t stamp_ns;       /* CLOCK_MONOTONIC of the companion computer, at the middle of the exposure */
  uint32_t width, height; /* pixels; of points: points in a row, and rows */
  uint32_t payload_bytes; /* of all rows: width * height * 2, 4 or 12 */
  uint32_t reserved;      /* 0 */
  /* The lens, pixels: a ray through pixel (u, v) has the direction ((u - cx) / fx, (v - cy) / fy, 1). The image is
   * undistorted. Of points: anything. */
  double fx, fy, cx, cy;
  double least, most; /* what the sensor can measure, m */
  /* Where it is mounted: its place in the body's axes (x ahead, y left, z up from the autopilot's reference), m, and
   * the unit quaternion (w, x, y, z) that turns its axes into the body's. A camera's axes are x right, y down, z ahead:
   * one that looks ahead and is level has (0.5, -0.5, 0.5, -0.5). */
  double position[3];
  double attitude[4];
} tern_depth_header;

#endif
