// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A request's limits as the stages read them: one convex set around zero for each derivative.
#ifndef TERN_BASE_BOUNDS_HPP
#define TERN_BASE_BOUNDS_HPP

#include "base/math.hpp"
#include "tern/request.hpp"

namespace tern {

/// A box around zero, cut by an upright cylinder.
struct Bounds {
  Vec3 lower;         ///< < 0 on every axis; -kUnlimited if there is no limit
  Vec3 upper;         ///< > 0 on every axis; kUnlimited if there is no limit
  double horizontal;  ///< radius of the cylinder; 0: there is none
};

/// A limit that no value reaches: value / kUnlimited is 0.
constexpr double kUnlimited = __builtin_inf();

/// Bounds from a request's limits. A lower limit of 0 stands for the negative of the upper one.
inline Bounds make_bounds(const Vec3& least, const Vec3& most, double horizontal) {
  Bounds bounds{least, most, horizontal};
  for (int a = 0; a < 3; ++a) {
    if (!(axis(least, a) < 0.0)) axis(bounds.lower, a) = -axis(most, a);
  }
  return bounds;
}

/// Symmetrical bounds, in which 0 stands for no limit.
inline Bounds make_optional_bounds(const Vec3& most, double horizontal) {
  Bounds bounds{{}, {}, horizontal};
  for (int a = 0; a < 3; ++a) {
    axis(bounds.upper, a) = axis(most, a) > 0.0 ? axis(most, a) : kUnlimited;
    axis(bounds.lower, a) = -axis(bounds.upper, a);
  }
  return bounds;
}

/// True if some value lies outside the bounds. An axis without an upper limit must have no lower limit.
inline bool limits_anything(const Bounds& bounds) {
  return bounds.horizontal > 0.0 || bounds.upper.x < kUnlimited || bounds.upper.y < kUnlimited ||
         bounds.upper.z < kUnlimited;
}

/// A request's limits as all stages except the check use them. Made once, when the request is accepted.
struct MotionLimits {
  Bounds velocity;      ///< m/s
  Bounds acceleration;  ///< m/s^2
  Bounds jerk;          ///< m/s^3; may limit nothing

  MotionLimits() = default;
  MotionLimits(const Limits& limits)
      : velocity(make_bounds(limits.v_min, limits.v_max, limits.v_horizontal)),
        acceleration(make_bounds(limits.a_min, limits.a_max, limits.a_horizontal)),
        jerk(make_optional_bounds(limits.j_max, limits.j_horizontal)) {}
};

/// The bounds' gauge: the least g >= 0 for which `value` is within g times the bounds. It is 1 if `value` touches the
/// bounds. It is convex, so over a convex hull it is largest at one of the hull's points.
inline double gauge(const Bounds& bounds, const Vec3& value) {
  double result = 0.0;
  for (int a = 0; a < 3; ++a) {
    const double x = axis(value, a);
    result = larger(result, x / (x < 0.0 ? axis(bounds.lower, a) : axis(bounds.upper, a)));
  }
  if (!(bounds.horizontal > 0.0)) return result;
  return larger(result, square_root(value.x * value.x + value.y * value.y) / bounds.horizontal);
}

/// The limits for flying a trajectory backwards in time. Velocities and jerks change sign, accelerations do not. Limits
/// of jerk are symmetrical.
inline MotionLimits backwards(const MotionLimits& limits) {
  MotionLimits result = limits;
  result.velocity.upper = -1.0 * limits.velocity.lower;
  result.velocity.lower = -1.0 * limits.velocity.upper;
  return result;
}

}  // namespace tern

#endif
