// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "times/trapezoid.hpp"

#include "base/bounds.hpp"
#include "curve/hermite.hpp"

namespace tern {

LineLimits limits_along(const Vec3& delta, const MotionLimits& limits) noexcept {
  const Vec3 direction = (1.0 / length(delta)) * delta;
  const Bounds& acceleration = limits.acceleration;
  // Speeding up and slowing down each have a limit of their own. Together they last as long as if both had the harmonic
  // mean.
  const double sluggishness = gauge(acceleration, direction) + gauge(acceleration, -1.0 * direction);
  return LineLimits{1.0 / gauge(limits.velocity, direction), 2.0 / sluggishness};
}

double ramp_acceleration(const Vec3& delta, const MotionLimits& limits, const LineLimits& line) noexcept {
  const Vec3 direction = (1.0 / length(delta)) * delta;
  const double stiffness = 0.5 * (ramp_gauge(limits, direction) + ramp_gauge(limits, -1.0 * direction));
  const double rise = line.acceleration * stiffness;  // seconds to full acceleration
  if (!(rise > 0.0)) return line.acceleration;
  const double seconds = line.speed / line.acceleration;
  return line.speed / (rise < seconds ? seconds + rise : 2.0 * square_root(line.speed * stiffness));
}

double trapezoid_time(double length, const LineLimits& limits) noexcept {
  const double v = limits.speed;
  const double a = limits.acceleration;
  const bool triangular = length * a < v * v;
  const double time = triangular ? 2.0 * square_root(length / a) : length / v + v / a;
  return larger(time, kMinDuration);
}

}  // namespace tern
