// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/motion_limits.hpp"

#include "base/math.hpp"
#include "trajectory/bezier.hpp"

namespace tern {

double stretch_to_limits(const Segment& segment, const Limits& limits) noexcept {
  // Peaks over their limits; a ratio below the largest yet is not looked into.
  double speed = 0.0;
  double squared = 0.0;
  for (int a = 0; a < 3; ++a) {
    const Curve velocity = hodograph(coordinate(segment, a), segment.duration);
    const double v_max = axis(limits.v_max, a);
    const double a_max = axis(limits.a_max, a);
    speed = larger(speed, peak_bound(velocity, speed * v_max, kPeakTolerance) / v_max);
    squared = larger(squared, speed * speed);
    squared =
        larger(squared, peak_bound(hodograph(velocity, segment.duration), squared * a_max, kPeakTolerance) / a_max);
    speed = square_root(squared);
  }
  return speed;
}

bool within_limits(const Segment& segment, const Limits& limits) noexcept {
  for (int a = 0; a < 3; ++a) {
    const Curve velocity = hodograph(coordinate(segment, a), segment.duration);
    const double v_max = axis(limits.v_max, a) * (1.0 + kLimitTolerance);
    const double a_max = axis(limits.a_max, a) * (1.0 + kLimitTolerance);
    if (peak_bound(velocity, v_max, 0.0) > v_max) return false;
    if (peak_bound(hodograph(velocity, segment.duration), a_max, 0.0) > a_max) return false;
  }
  return true;
}

bool inside(const Segment& segment, const Polyhedron& polyhedron) noexcept {
  for (const Vec3& point : segment.points) {
    for (int p = 0; p < polyhedron.count; ++p) {
      if (dot(polyhedron.planes[p].normal, point) > polyhedron.planes[p].offset + kInsideTolerance) return false;
    }
  }
  return true;
}

}  // namespace tern
