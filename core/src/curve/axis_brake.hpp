// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Braking that stops each axis as sharply as its own limit allows. If all axes stop together (brake.hpp) and their
// limits are unequal, every axis takes as long as the weakest one.
#ifndef TERN_CURVE_AXIS_BRAKE_HPP
#define TERN_CURVE_AXIS_BRAKE_HPP

#include "base/bounds.hpp"
#include "curve/hermite.hpp"
#include "tern/request.hpp"

namespace tern {

/// Each axis has a ramp, a hold and a ramp back; the first ramps end together.
constexpr int kAxisBrakeSegments = 7;

/// The states at the joints. Between two joints every axis is one polynomial of degree 5 at most, so the segment of
/// degree 7 between their states is exactly the motion. The first state is the given one; the last is at rest.
struct AxisBrake {
  int segments;
  double duration[kAxisBrakeSegments];
  JointState joint[kAxisBrakeSegments + 1];
};

/// The braking with ramps of `ramp` seconds. Each axis has the shortest hold that its limits allow, in quarters of a
/// ramp. Limits on horizontal norms are ignored.
AxisBrake make_axis_brake(const State& state, const MotionLimits& limits, double ramp) noexcept;

}  // namespace tern

#endif
