// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <uORB/uORB.h>

struct distance_sensor_s {
  static constexpr uint8_t ROTATION_YAW_315 = 7;
  static constexpr uint8_t ROTATION_FORWARD_FACING = 0;
  static constexpr uint8_t ROTATION_DOWNWARD_FACING = 25;
  static constexpr uint8_t ROTATION_CUSTOM = 100;
  static constexpr uint8_t MODE_DISABLED = 2;
  uint64_t timestamp;      // us
  float min_distance;      // m
  float max_distance;      // m
  float current_distance;  // m
  float h_fov;             // rad
  float v_fov;             // rad
  float q[4];              // from the sensor's axes to the body's, for ROTATION_CUSTOM
  int8_t signal_quality;   // percent; 0: invalid, -1: unknown
  uint8_t type;
  uint8_t orientation;
  uint8_t mode;
};

ORB_DECLARE(distance_sensor);
