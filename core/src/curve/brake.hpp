// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Braking from any state to rest in closed form: a ramp to a steady deceleration, a hold, a ramp back to none. All axes
// stop at the same time. No solver and no luck: with short ramps it stops within little more than v^2 / 2a.
#ifndef TERN_CURVE_BRAKE_HPP
#define TERN_CURVE_BRAKE_HPP

#include "base/bounds.hpp"
#include "curve/hermite.hpp"
#include "tern/corridor.hpp"
#include "tern/request.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// Ramps tried, the first as long as full deceleration takes, each kBrakeSharper times the one before, kMinDuration at
/// least: the gentlest needs twice the least way to stop, the sharpest 1 % more (or what kMinDuration takes).
constexpr int kBrakeShapes = 8;
constexpr double kBrakeSharper = 0.5;
/// The same for the ramp that surely keeps the limits on jerk.
constexpr double kBrakeLessSmooth = 0.9;
constexpr int kBrakeSegments = 3;

/// Segments of degree 7 (the curve itself has degree 5), continuous to jerk, which is zero at every joint but the
/// first.
struct Brake {
  double duration[kBrakeSegments];       ///< ramp, hold, ramp: seconds, >= kMinDuration
  JointState joint[kBrakeSegments + 1];  ///< the last one at rest, exactly
};

/// Largest slope of the smooth step 3 u^2 - 2 u^3 by which ramps change the acceleration.
constexpr double kSmoothStepPeak = 1.5;
/// The jerk that a ramp of r seconds begins with adds r (u - 2 u^2 + u^3) times itself to the acceleration: these parts
/// of r^2 to the velocity and of r^3 to the way.
constexpr double kJerkToVelocity = 1.0 / 12.0;
constexpr double kJerkToWay = 1.0 / 20.0;

/// The braking whose ramps have shape 0 .. kBrakeShapes - 1, and whose hold is as short as the limits on acceleration
/// allow; ramps and hold last `least` seconds at least, and ramps as long as the limits on jerk ask for. Nothing else
/// is looked at.
Brake make_brake(const State& state, const MotionLimits& limits, int shape, double least = kMinDuration) noexcept;

/// The state after `time` of a ramp to another acceleration, jerk zero at its end; where both are equal and the jerk is
/// zero, of a hold.
JointState after_ramp(const JointState& from, const Vec3& acceleration, double time) noexcept;

inline const Vec3& stopping_point(const Brake& brake) noexcept {
  return brake.joint[kBrakeSegments].d[0];
}

/// Its segment 0 .. kBrakeSegments - 1.
Segment brake_segment(const Brake& brake, int part, int polyhedron) noexcept;

/// The gentlest braking that keeps the limits and the polyhedron. False where none does.
bool find_brake(const State& state, const Polyhedron& polyhedron, const MotionLimits& limits, Brake& brake) noexcept;

}  // namespace tern

#endif
