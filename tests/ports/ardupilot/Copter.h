// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stand-in for ArduCopter's class: what its user hooks need.
#pragma once

#include <AP_Math/AP_Math.h>

struct RC_Channel {
  enum class AuxSwitchPos : uint8_t { LOW, MIDDLE, HIGH };
};

struct Mode {
  enum class Number : uint8_t { GUIDED = 4, LOITER = 5 };
  Number number = Number::GUIDED;
  Number mode_number() const { return number; }
};

struct Motors {
  bool is_armed = true;
  bool armed() const { return is_armed; }
};

struct Ahrs {
  Vector3f position, velocity;
  bool get_relative_position_NED_origin(Vector3f& vec) const {
    vec = position;
    return true;
  }
  bool get_velocity_NED(Vector3f& vec) const {
    vec = velocity;
    return true;
  }
};

class Copter {
 public:
  void userhook_init();
  void userhook_50Hz();
  void userhook_auxSwitch1(const RC_Channel::AuxSwitchPos ch_flag);

  Mode* flightmode;
  Motors* motors;
  Ahrs ahrs;
  struct {
    bool land_complete;
  } ap;
};
