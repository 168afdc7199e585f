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
  float x;        // m, north
  float y;        // m, east
  float z;        // m, down
  float heading;  // rad, -pi .. pi, clockwise from north
};

ORB_DECLARE(vehicle_local_position);
