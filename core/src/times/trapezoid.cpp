// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "times/times.hpp"

namespace tern {

LineLimits limits_along(const Vec3& delta, const Limits& limits) noexcept {
  // Seconds per metre, and seconds squared per metre, that the slowest axis needs.
  const double norm = length(delta);
  double slowness = 0.0;
  double sluggishness = 0.0;
  for (int a = 0; a < 3; ++a) {
    const double part = absolute(axis(delta, a)) / norm;
    slowness = larger(slowness, part / axis(limits.v_max, a));
    sluggishness = larger(sluggishness, part / axis(limits.a_max, a));
  }
  return LineLimits{1.0 / slowness, 1.0 / sluggishness};
}

double trapezoid_time(double length, const LineLimits& limits) noexcept {
  const double v = limits.speed;
  const double a = limits.acceleration;
  const bool triangular = length * a < v * v;
  const double time = triangular ? 2.0 * square_root(length / a) : length / v + v / a;
  return larger(time, kMinDuration);
}

void allocate_times(const Corridor& corridor, const Limits& limits, double* durations) noexcept {
  for (int i = 0; i < corridor.count; ++i) {
    const Vec3 delta = corridor.polyhedra[i].to - corridor.polyhedra[i].from;
    const double x = length(delta);
    durations[i] = x > 0.0 ? trapezoid_time(x, limits_along(delta, limits)) : kMinDuration;
  }
}

}  // namespace tern
