// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <uORB/uORB.h>

struct vehicle_attitude_s {
  uint64_t timestamp;  // us
  float q[4];          // from forward, right, down to north, east, down
};

ORB_DECLARE(vehicle_attitude);
