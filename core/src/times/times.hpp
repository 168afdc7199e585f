// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Time allocation (the paper's Section 3.3.2): how long a straight segment takes from rest to rest.
#ifndef TERN_TIMES_TIMES_HPP
#define TERN_TIMES_TIMES_HPP

#include "tern/corridor.hpp"
#include "tern/request.hpp"

namespace tern {

/// No segment lasts less, seconds: what a segment of zero length gets, and the floor of every refinement. Derivatives
/// are differences of control points over powers of the duration, so that it also bounds their rounding errors:
/// 1e-14 m over (0.05 s)^3 is 2e-8 m/s^3 of jerk.
constexpr double kMinDuration = 0.05;

/// A speed and an acceleration along one direction.
struct LineLimits {
  double speed;         ///< m/s
  double acceleration;  ///< m/s^2
};

/// The limits along the direction of `delta` (any length but zero): the largest that keep all of them. Where speeding
/// up and slowing down have different limits the acceleration is their harmonic mean, which gives a profile from rest
/// to rest the same duration.
LineLimits limits_along(const Vec3& delta, const Limits& limits) noexcept;

/// Seconds of the trapezoidal velocity profile over `length` metres from rest to rest, x / v + v / a; triangular,
/// 2 sqrt(x / a), where the segment is too short to reach v. kMinDuration at least.
double trapezoid_time(double length, const LineLimits& limits) noexcept;

/// The profile's time for every segment of the corridor, from its `from` to its `to`. `durations`: corridor.count
/// values, seconds. Limits must be within [kMinLimit, kMaxLimit].
void allocate_times(const Corridor& corridor, const Limits& limits, double* durations) noexcept;

}  // namespace tern

#endif
