// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The fields of PX4's OffboardControlMode.msg.
#pragma once

#include <uORB/uORB.h>

struct offboard_control_mode_s {
  uint64_t timestamp;  // us
  bool position;
  bool velocity;
  bool acceleration;
  bool attitude;
  bool body_rate;
  bool thrust_and_torque;
  bool direct_actuator;
};

ORB_DECLARE(offboard_control_mode);
