// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stand-in for ArduPilot's vehicle, which records what guided mode is told.
#pragma once

#include <AP_Math/AP_Math.h>

class AP_Vehicle {
 public:
  virtual ~AP_Vehicle() {}
  virtual bool set_target_posvelaccel_NED(const Vector3f& target_pos, const Vector3f& target_vel,
                                          const Vector3f& target_accel, bool use_yaw, float yaw_deg, bool use_yaw_rate,
                                          float yaw_rate_degs, bool yaw_relative);
};

namespace AP {
AP_Vehicle* vehicle();
}
