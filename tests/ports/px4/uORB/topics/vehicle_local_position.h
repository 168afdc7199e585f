// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The fields of PX4's VehicleLocalPosition.msg that the example reads.
#pragma once

#include <uORB/uORB.h>

struct vehicle_local_position_s {
  uint64_t timestamp;  // us
  bool xy_valid;
  bool z_valid;
  bool v_xy_valid;
  bool v_z_valid;
  float x;  // m, north
  float y;  // m, east
  float z;  // m, down
  uint8_t xy_reset_counter;
  uint8_t z_reset_counter;
  float vx;  // m/s
  float vy;
  float vz;
  uint8_t vxy_reset_counter;
  uint8_t vz_reset_counter;
  float heading;  // rad, -pi .. pi, clockwise from north
  uint8_t heading_reset_counter;
};

ORB_DECLARE(vehicle_local_position);
