// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "curve/rest.hpp"

#include "base/bounds.hpp"
#include "curve/hermite.hpp"

namespace tern {
namespace {

bool is_zero(const Vec3& v) {
  return !(dot(v, v) > 0.0);
}

/// Of a leg flown with accelerations of up to 1 / pull times the move: the largest body rate over the jerk, in parts of
/// the move. The jerk is along the leg, so it turns the thrust by its part across gravity.
double turn_of(const Vec3& move, double pull) {
  const double most = 1.0 / pull;
  const double lightest = clamp(-kGravity * move.z / dot(move, move), -most, most);
  const Vec3 thrust = lightest * move + Vec3{0.0, 0.0, kGravity};
  return kGravity * horizontal_length(move) / dot(thrust, thrust);
}

}  // namespace

bool at_rest(const State& state) noexcept {
  return is_zero(state.velocity) && is_zero(state.acceleration) && is_zero(state.jerk);
}

Segment reversed(const Segment& segment) noexcept {
  Segment result = segment;
  for (int k = 0; k < kControlPoints; ++k) result.points[k] = segment.points[kDegree - k];
  return result;
}

State backwards(const State& state) noexcept {
  return State{state.position, kZero - state.velocity, state.acceleration, kZero - state.jerk};
}

Segment straight_segment(const Vec3& from, const Vec3& to, int polyhedron, const MotionLimits& limits) noexcept {
  Segment segment{};
  segment.polyhedron = polyhedron;
  const Vec3 move = to - from;
  const Bounds& acceleration = limits.acceleration;
  const double pull = larger(gauge(acceleration, move), gauge(acceleration, kZero - move));
  const double cruise = kRestPeakSpeed * gauge(limits.velocity, move);
  segment.duration = larger(kMinDuration, larger(cruise, square_root(kRestPeakAcceleration * pull)));
  segment.duration = larger(segment.duration, cube_root(kRestPeakJerk * gauge(limits.jerk, move)));
  if (limits.rate > 0.0) {
    segment.duration = larger(segment.duration, cube_root(kRestPeakJerk * turn_of(move, pull) / limits.rate));
  }
  for (int k = 0; k < kJointOrder; ++k) {
    segment.points[k] = from;
    segment.points[kDegree - k] = to;
  }
  return segment;
}

}  // namespace tern
