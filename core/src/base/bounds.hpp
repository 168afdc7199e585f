// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A request's limits as the stages read them: one convex set around zero for each derivative.
#ifndef TERN_BASE_BOUNDS_HPP
#define TERN_BASE_BOUNDS_HPP

#include "base/math.hpp"
#include "tern/flatness.hpp"
#include "tern/request.hpp"

namespace tern {

/// A box around zero, cut by an upright cylinder, and for accelerations by a ball and a cone of the thrust, which is
/// the acceleration plus the hover's.
struct Bounds {
  Vec3 lower;           ///< < 0 on every axis; -kUnlimited if there is no limit
  Vec3 upper;           ///< > 0 on every axis; kUnlimited if there is no limit
  double horizontal;    ///< radius of the cylinder; 0: there is none
  double hover = 0.0;   ///< the thrust at rest, along z
  double thrust = 0.0;  ///< radius of the ball, > hover; 0: there is none
  double slope = 0.0;   ///< horizontal over vertical thrust on the cone; 0: there is none
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

/// The largest horizontal norm within the box and the cylinder.
inline double horizontal_extent(const Bounds& bounds) {
  const double x = larger(bounds.upper.x, -bounds.lower.x);
  const double y = larger(bounds.upper.y, -bounds.lower.y);
  const double corner = square_root(x * x + y * y);
  return bounds.horizontal > 0.0 ? smaller(bounds.horizontal, corner) : corner;
}

/// A limit of the vehicle counts as implied by others if they leave this much of it.
constexpr double kImplied = 1.0 - 1e-6;

/// Bounds of the acceleration. With a limit on thrust or tilt, the thrust never points down; its vertical part is at
/// least thrust_min, and so is the thrust. Limits that the box and the cylinder imply are left out: they cost work.
inline Bounds make_acceleration_bounds(const Limits& limits) {
  Bounds bounds = make_bounds(limits.a_min, limits.a_max, limits.a_horizontal);
  bounds.hover = kGravity;
  const bool has_thrust = limits.thrust_max > 0.0 || limits.thrust_min > 0.0 || limits.tilt_tangent > 0.0;
  if (has_thrust) bounds.lower.z = larger(bounds.lower.z, limits.thrust_min - kGravity);
  const double extent = horizontal_extent(bounds);
  const double heaviest = kGravity + bounds.upper.z;
  const double most = kImplied * limits.thrust_max;
  if (extent * extent + heaviest * heaviest > most * most) bounds.thrust = limits.thrust_max;
  if (extent > kImplied * limits.tilt_tangent * (kGravity + bounds.lower.z)) bounds.slope = limits.tilt_tangent;
  return bounds;
}

/// The same bounds, `factor` times as large.
inline Bounds scaled(double factor, const Bounds& bounds) {
  return {factor * bounds.lower, factor * bounds.upper,  factor * bounds.horizontal,
          factor * bounds.hover, factor * bounds.thrust, bounds.slope};
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
  double rate = 0.0;    ///< rad/s: of |jerk x thrust| / |thrust|^2; 0: no limit, or one that the others imply

  MotionLimits() = default;
  MotionLimits(const Limits& limits)
      : velocity(make_bounds(limits.v_min, limits.v_max, limits.v_horizontal)),
        acceleration(make_acceleration_bounds(limits)),
        jerk(make_optional_bounds(limits.j_max, limits.j_horizontal)) {
    const double extent = horizontal_extent(jerk);
    const double sharpest = square_root(extent * extent + jerk.upper.z * jerk.upper.z);
    const double allowed = kImplied * limits.rate_max * (kGravity + acceleration.lower.z);
    if (sharpest > allowed) rate = limits.rate_max;
  }
};

/// The least g >= 0 for which  value / g  plus the hover's thrust is in the ball and in the cone.
inline double thrust_gauge(const Bounds& bounds, const Vec3& value) {
  double result = 0.0;
  const double square = value.x * value.x + value.y * value.y;
  if (bounds.thrust > 0.0) {
    // The larger root of  room g^2 - 2 lift g - |value|^2 = 0, in the form that does not cancel.
    const double room = (bounds.thrust - bounds.hover) * (bounds.thrust + bounds.hover);
    const double lift = bounds.hover * value.z;
    const double whole = square + value.z * value.z;
    const double root = square_root(lift * lift + room * whole);
    if (root > 0.0) result = lift > 0.0 ? (lift + root) / room : whole / (root - lift);
  }
  if (bounds.slope > 0.0) result = larger(result, (square_root(square) / bounds.slope - value.z) / bounds.hover);
  return result;
}

/// The bounds' gauge: the least g >= 0 for which `value` is within g times the bounds. It is 1 if `value` touches the
/// bounds. It is convex, so over a convex hull it is largest at one of the hull's points.
inline double gauge(const Bounds& bounds, const Vec3& value) {
  double result = 0.0;
  for (int a = 0; a < 3; ++a) {
    const double x = axis(value, a);
    result = larger(result, x / (x < 0.0 ? axis(bounds.lower, a) : axis(bounds.upper, a)));
  }
  if (bounds.thrust > 0.0 || bounds.slope > 0.0) result = larger(result, thrust_gauge(bounds, value));
  if (!(bounds.horizontal > 0.0)) return result;
  return larger(result, horizontal_length(value) / bounds.horizontal);
}

/// A box within the bounds, for manoeuvres that treat each axis by itself: the bounds' own box, smaller if its corners
/// ask too much of the thrust. Horizontal norms are left aside.
inline Bounds inner_box(const Bounds& bounds) {
  if (!(bounds.thrust > 0.0 || bounds.slope > 0.0)) return bounds;
  double excess = 1.0;
  for (int corner = 0; corner < 8; ++corner) {
    excess = larger(excess, thrust_gauge(bounds, {corner % 2 == 0 ? bounds.lower.x : bounds.upper.x,
                                                  corner / 2 % 2 == 0 ? bounds.lower.y : bounds.upper.y,
                                                  corner / 4 == 0 ? bounds.lower.z : bounds.upper.z}));
  }
  return scaled(1.0 / excess, bounds);
}

/// What a jerk costs in a ramp that is to be built: the gauge of the limits on jerk, and with a limit on body rates,
/// the part of it that the jerk takes at the hover's thrust. Whoever builds a ramp checks the rates themselves
/// afterwards.
inline double ramp_gauge(const MotionLimits& limits, const Vec3& jerk) {
  const double result = gauge(limits.jerk, jerk);
  return limits.rate > 0.0 ? larger(result, length(jerk) / (limits.rate * kGravity)) : result;
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
