// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "curve/motion_limits.hpp"

#include "base/math.hpp"
#include "base/polyhedron.hpp"
#include "curve/bezier.hpp"
#include "curve/body_rate.hpp"

namespace tern {

double stretch_to_limits(const Segment& segment, const MotionLimits& limits) noexcept {
  const Curve velocity = hodograph(curve_of(segment), segment.duration);
  const double speed = peak_bound(velocity, limits.velocity, 0.0, kPeakTolerance);
  // Peaks of the acceleration that need no more stretch than the speed does are not resolved.
  const Curve acceleration = hodograph(velocity, segment.duration);
  const double factor = square_root(peak_bound(acceleration, limits.acceleration, speed * speed, kPeakTolerance));
  if (!limits_anything(limits.jerk)) return factor;
  const Curve jerk = hodograph(acceleration, segment.duration);
  const double floor = factor * factor * factor;
  const double peak = peak_bound(jerk, limits.jerk, floor, kPeakTolerance);
  return peak > floor ? cube_root((1.0 + kJerkMargin) * peak) : factor;
}

bool within_limits(const Segment& segment, const MotionLimits& limits, double tolerance) noexcept {
  const double most = 1.0 + tolerance;
  const Curve velocity = hodograph(curve_of(segment), segment.duration);
  if (peak_bound(velocity, limits.velocity, most, 0.0) > most) return false;
  const Curve acceleration = hodograph(velocity, segment.duration);
  if (peak_bound(acceleration, limits.acceleration, most, 0.0) > most) return false;
  const double most_jerk = 1.0 + kJerkTolerance;
  if (limits_anything(limits.jerk)) {
    const Curve jerk = hodograph(acceleration, segment.duration);
    if (peak_bound(jerk, limits.jerk, most_jerk, 0.0) > most_jerk) return false;
  }
  if (!(limits.rate > 0.0)) return true;
  const double most_rate = most_jerk * limits.rate;
  return !(peak_rate(segment, most_rate, 0.0) > most_rate);
}

bool inside(const Segment& segment, const Polyhedron& polyhedron) noexcept {
  for (const Vec3& point : segment.points) {
    if (!holds(polyhedron, point, -kInsideTolerance)) return false;
  }
  return true;
}

}  // namespace tern
