// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// For ArduCopter/UserCode.cpp: constructs AP_Tern and calls it. RC option 47 (user function 1) begins a flight to GOAL
// when the switch is high, and stops it when it is not.
#include <AP_Tern/AP_Tern.h>
#include <stdlib.h>

#include "Copter.h"

// Yours. Map: east, north, up from the EKF's origin. Goal: north, east, down. Metres.
static const tern_grid_spec SPEC = {{-5, -10, -1}, 0.2, {100, 100, 35}, {{-5, -10, 0.5}, {15, 10, 6}}, 0.3, 0.3};
static const tern_box OBSTACLES[] = {{{4, -3, 0}, {5, 3, 5}}};
static const Vector3f GOAL(2, 10, -2);

static AP_Tern* planner;

// The vehicle's position, under the name that it has since 4.7 or, where there is no such function, before.
template <typename Estimate>
static auto read_position(const Estimate& estimate, Vector3f& ned, int)
    -> decltype(estimate.get_relative_position_NED_origin_float(ned)) {
  return estimate.get_relative_position_NED_origin_float(ned);
}

template <typename Estimate>
static auto read_position(const Estimate& estimate, Vector3f& ned, long)
    -> decltype(estimate.get_relative_position_NED_origin(ned)) {
  return estimate.get_relative_position_NED_origin(ned);
}

void Copter::userhook_init() {
  const size_t bytes = tern_size_of(TERN_SIZE_WORKSPACE);
  const size_t words = tern_grid_words(SPEC.dims);
  static AP_Tern only(malloc(bytes), bytes, static_cast<uint64_t*>(calloc(words, sizeof(uint64_t))), words);
  if (only.set_map(SPEC, OBSTACLES, 1)) {
    planner = &only;
  }
}

void Copter::userhook_50Hz() {
  if (planner == nullptr) {
    return;
  }
  AP_Tern::Vehicle now;
  now.ready = flightmode->mode_number() == Mode::Number::GUIDED && motors->armed() && !ap.land_complete &&
              read_position(ahrs, now.position, 0) && ahrs.get_velocity_NED(now.velocity);
  planner->update(now);
}

void Copter::userhook_auxSwitch1(const RC_Channel::AuxSwitchPos position) {
  if (planner == nullptr) {
    return;
  }
  if (position == RC_Channel::AuxSwitchPos::HIGH) {
    planner->fly_to(GOAL);
  } else {
    planner->stop();
  }
}
