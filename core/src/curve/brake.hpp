// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Braking from any state to rest in closed form: a ramp to a steady deceleration, a hold, a ramp back to none. All axes
// stop at the same time. It needs no solver. With short ramps it stops within little more than v^2 / 2a.
#ifndef TERN_CURVE_BRAKE_HPP
#define TERN_CURVE_BRAKE_HPP

#include "base/bounds.hpp"
#include "curve/hermite.hpp"
#include "tern/corridor.hpp"
#include "tern/request.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// Lengths of ramps that are tried. The first is as long as full deceleration takes; each further one is kBrakeSharper
/// times the one before, but at least kMinDuration. The gentlest braking needs twice the least way to stop. The
/// sharpest needs 1 % more than the least way, or the way of ramps of kMinDuration.
constexpr int kBrakeShapes = 8;
constexpr double kBrakeSharper = 0.5;
/// The ramp that surely keeps the limits on jerk is shortened by this factor from shape to shape.
constexpr double kBrakeLessSmooth = 0.9;
constexpr int kBrakeSegments = 3;

/// A braking, as segments of degree 7 (the curve itself has degree 5). It is continuous to jerk, which is zero at every
/// joint but the first.
struct Brake {
  double duration[kBrakeSegments];       ///< ramp, hold, ramp: seconds, >= `least` of make_brake
  JointState joint[kBrakeSegments + 1];  ///< the last one at rest, exactly
};

/// Largest slope of the smooth step 3 u^2 - 2 u^3 that the acceleration follows in a ramp.
constexpr double kSmoothStepPeak = 1.5;
/// The initial jerk of a ramp of r seconds adds r (u - 2 u^2 + u^3) times that jerk to the acceleration. So it adds
/// these parts of the jerk, times r^2 and r^3, to the velocity and to the way.
constexpr double kJerkToVelocity = 1.0 / 12.0;
constexpr double kJerkToWay = 1.0 / 20.0;

/// The braking with ramps of `shape` 0 .. kBrakeShapes - 1, and with the shortest hold that the limits on acceleration
/// allow. Ramps and hold last at least `least` seconds, and ramps at least as long as the limits on jerk ask for. No
/// other limits are considered.
Brake make_brake(const State& state, const MotionLimits& limits, int shape, double least = kMinDuration) noexcept;

/// The state at the end of a ramp of `time` seconds to `acceleration`; the jerk there is zero. If the acceleration does
/// not change and the initial jerk is zero, the ramp is a hold.
JointState after_ramp(const JointState& from, const Vec3& acceleration, double time) noexcept;

inline const Vec3& stopping_point(const Brake& brake) noexcept {
  return brake.joint[kBrakeSegments].d[0];
}

/// Segment `part` of the braking, 0 .. kBrakeSegments - 1.
Segment brake_segment(const Brake& brake, int part, int polyhedron) noexcept;

/// The gentlest braking that keeps the limits and the polyhedron. False if none does.
bool find_brake(const State& state, const Polyhedron& polyhedron, const MotionLimits& limits, Brake& brake) noexcept;

}  // namespace tern

#endif
