// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The fields of PX4's TrajectorySetpoint.msg, version 0.
#pragma once

#include <uORB/uORB.h>

struct trajectory_setpoint_s {
  uint64_t timestamp;     // us
  float position[3];      // m, north east down
  float velocity[3];      // m/s
  float acceleration[3];  // m/s^2
  float jerk[3];          // m/s^3
  float yaw;              // rad, -pi .. pi
  float yawspeed;         // rad/s about down
};

ORB_DECLARE(trajectory_setpoint);
