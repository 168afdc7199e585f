// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The fields of PX4's VehicleStatus.msg that the example reads.
#pragma once

#include <uORB/uORB.h>

struct vehicle_status_s {
  static constexpr uint8_t ARMING_STATE_DISARMED = 1;
  static constexpr uint8_t ARMING_STATE_ARMED = 2;
  static constexpr uint8_t NAVIGATION_STATE_POSCTL = 2;
  static constexpr uint8_t NAVIGATION_STATE_AUTO_RTL = 5;
  static constexpr uint8_t NAVIGATION_STATE_OFFBOARD = 14;
  uint64_t timestamp;  // us
  uint8_t arming_state;
  uint8_t nav_state;
};

ORB_DECLARE(vehicle_status);
