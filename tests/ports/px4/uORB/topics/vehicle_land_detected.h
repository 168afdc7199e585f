// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The fields of PX4's VehicleLandDetected.msg that the example reads.
#pragma once

#include <uORB/uORB.h>

struct vehicle_land_detected_s {
  uint64_t timestamp;  // us
  bool landed;
};

ORB_DECLARE(vehicle_land_detected);
