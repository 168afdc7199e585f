// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <uORB/uORB.h>

struct obstacle_distance_s {
  static constexpr uint8_t MAV_FRAME_GLOBAL = 0;
  static constexpr uint8_t MAV_FRAME_LOCAL_NED = 1;
  static constexpr uint8_t MAV_FRAME_BODY_FRD = 12;
  uint64_t timestamp;      // us
  float increment;         // degrees
  float angle_offset;      // degrees
  uint16_t distances[72];  // cm; 65535: unknown
  uint16_t min_distance;   // cm
  uint16_t max_distance;   // cm
  uint8_t frame;
  uint8_t sensor_type;
};

ORB_DECLARE(obstacle_distance);
