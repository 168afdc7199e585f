// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Braking each axis as sharply as its own limit allows: where limits are unequal, axes that stop together (brake.hpp)
// go on as long as the weakest one needs.
#ifndef TERN_CURVE_AXIS_BRAKE_HPP
#define TERN_CURVE_AXIS_BRAKE_HPP

#include "base/bounds.hpp"
#include "curve/hermite.hpp"
#include "tern/request.hpp"

namespace tern {

/// Each axis has a ramp, a hold and a ramp back; the first ramps end together.
constexpr int kAxisBrakeSegments = 7;

/// States at the joints; between them every axis is one polynomial of degree 5 at most, so that a segment of degree 7
/// between the states is the motion itself. The first state is the one given; the last is at rest.
struct AxisBrake {
  int segments;
  double duration[kAxisBrakeSegments];
  JointState joint[kAxisBrakeSegments + 1];
};

/// Ramps of `ramp` seconds; holds are as short as the limits of each axis allow, in quarters of a ramp. A limit on the
/// horizontal norm is not looked at.
AxisBrake make_axis_brake(const State& state, const MotionLimits& limits, double ramp) noexcept;

}  // namespace tern

#endif
