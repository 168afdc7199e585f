// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "prove/allowed.hpp"

#include "base/math.hpp"
#include "tern/flatness.hpp"

namespace tern {
namespace {

/// Stands for the limit of an axis whose jerk is not limited.
constexpr double kAnyValue = __builtin_inf();

/// A lower limit of 0 stands for minus the upper limit.
Allowed widened(const Vec3& least, const Vec3& most, double horizontal, double excess, double rounding) {
  const double wider = 1.0 + excess;
  Allowed allowed{wider * least, wider * most, 0.0};
  for (int a = 0; a < 3; ++a) {
    if (!(axis(least, a) < 0.0)) axis(allowed.least, a) = -axis(allowed.most, a);
    axis(allowed.least, a) -= rounding;
    axis(allowed.most, a) += rounding;
  }
  if (horizontal > 0.0) allowed.horizontal = wider * horizontal + 2.0 * rounding;
  return allowed;
}

/// Accelerations. The thrust exceeds its limit by `excess` of both the limit and gravity at most.
Allowed allowed_accelerations(const Limits& limits, double excess, double rounding) {
  Vec3 least = limits.a_min;
  const double lowest = least.z < 0.0 ? least.z : -limits.a_max.z;
  const bool has_thrust = limits.thrust_max > 0.0 || limits.thrust_min > 0.0 || limits.tilt_tangent > 0.0;
  if (has_thrust) least.z = larger(lowest, limits.thrust_min - kGravity);
  Allowed allowed = widened(least, limits.a_max, limits.a_horizontal, excess, rounding);
  const double spare = excess * kGravity + 2.0 * rounding;
  if (limits.thrust_max > 0.0) allowed.thrust = (1.0 + excess) * limits.thrust_max + spare;
  allowed.slope = limits.tilt_tangent;
  allowed.spare = limits.tilt_tangent > 0.0 ? spare + 2.0 * rounding / limits.tilt_tangent : spare;
  return allowed;
}

/// By how much the thrust at this acceleration is beyond the ball, and the horizontal thrust beyond the cone.
double beyond_ball(const Allowed& allowed, const Vec3& value) {
  return length(value + Vec3{0.0, 0.0, kGravity}) - allowed.thrust;
}
double beyond_cone(const Allowed& allowed, const Vec3& value) {
  const double vertical = value.z + kGravity + allowed.spare;
  return horizontal_length(value) - allowed.slope * vertical;
}

bool is_allowed(const Allowed& allowed, const Vec3& value) {
  for (int a = 0; a < 3; ++a) {
    if (!(axis(value, a) <= axis(allowed.most, a) && axis(value, a) >= axis(allowed.least, a))) return false;
  }
  if (allowed.thrust > 0.0 && !(beyond_ball(allowed, value) <= 0.0)) return false;
  if (allowed.slope > 0.0 && !(beyond_cone(allowed, value) <= 0.0)) return false;
  const double square = value.x * value.x + value.y * value.y;
  return !(allowed.horizontal > 0.0) || square <= allowed.horizontal * allowed.horizontal;
}

}  // namespace

Allowed allowed_by(const Limits& limits, int derivative, double excess, double rounding) noexcept {
  if (derivative == 1) return widened(limits.v_min, limits.v_max, limits.v_horizontal, excess, rounding);
  if (derivative == 2) return allowed_accelerations(limits, excess, rounding);
  Vec3 most = limits.j_max;
  for (int a = 0; a < 3; ++a) {
    if (!(axis(most, a) > 0.0)) axis(most, a) = kAnyValue;
  }
  return widened(kZero, most, limits.j_horizontal, excess, rounding);
}

bool limits_jerk(const Limits& limits) noexcept {
  return limits.j_max.x > 0.0 || limits.j_max.y > 0.0 || limits.j_max.z > 0.0 || limits.j_horizontal > 0.0;
}

bool limits_turning(const Limits& limits) noexcept {
  return limits.rate_max > 0.0;
}

bool hull_allowed(const Allowed& allowed, const Vec3* points, int count) noexcept {
  for (int i = 0; i < count; ++i) {
    if (!is_allowed(allowed, points[i])) return false;
  }
  return true;
}

Excess excess_of(const Allowed& allowed, const Vec3& value) noexcept {
  Excess most{-1, 0.0};
  for (int a = 0; a < 3; ++a) {
    const double beyond = larger(axis(value, a) - axis(allowed.most, a), axis(allowed.least, a) - axis(value, a));
    if (beyond > most.amount) most = {a, beyond};
  }
  const double norm = horizontal_length(value) - allowed.horizontal;
  if (allowed.horizontal > 0.0 && norm > most.amount) most = {kHorizontalNorm, norm};
  if (allowed.thrust > 0.0 && beyond_ball(allowed, value) > most.amount) {
    most = {kThrustNorm, beyond_ball(allowed, value)};
  }
  if (allowed.slope > 0.0 && beyond_cone(allowed, value) > most.amount) {
    most = {kTiltNorm, beyond_cone(allowed, value)};
  }
  return most;
}

}  // namespace tern
