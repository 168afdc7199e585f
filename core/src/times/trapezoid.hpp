// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Time allocation (the paper's Section 3.3.2): how long a straight segment takes from rest to rest.
#ifndef TERN_TIMES_TRAPEZOID_HPP
#define TERN_TIMES_TRAPEZOID_HPP

#include "base/bounds.hpp"
#include "tern/request.hpp"

namespace tern {

/// A speed and an acceleration along one direction.
struct LineLimits {
  double speed;         ///< m/s
  double acceleration;  ///< m/s^2
};

/// The largest speed and acceleration along the direction of `delta` (any length but zero) that keep all limits. If
/// speeding up and slowing down have different limits, the acceleration is their harmonic mean, which gives a profile
/// from rest to rest the same duration.
LineLimits limits_along(const Vec3& delta, const MotionLimits& limits) noexcept;

/// The mean acceleration along `delta` from rest to line.speed, at most line.acceleration: less if a limit on jerk
/// makes the acceleration rise and fall gradually.
double ramp_acceleration(const Vec3& delta, const MotionLimits& limits, const LineLimits& line) noexcept;

/// Seconds of the trapezoidal velocity profile over `length` metres from rest to rest, x / v + v / a. If the segment is
/// too short to reach v, the profile is triangular, 2 sqrt(x / a). At least kMinDuration.
double trapezoid_time(double length, const LineLimits& limits) noexcept;

}  // namespace tern

#endif
