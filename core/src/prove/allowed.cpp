// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "prove/allowed.hpp"

#include "base/math.hpp"

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

bool is_allowed(const Allowed& allowed, const Vec3& value) {
  for (int a = 0; a < 3; ++a) {
    if (!(axis(value, a) <= axis(allowed.most, a) && axis(value, a) >= axis(allowed.least, a))) return false;
  }
  const double square = value.x * value.x + value.y * value.y;
  return !(allowed.horizontal > 0.0) || square <= allowed.horizontal * allowed.horizontal;
}

}  // namespace

Allowed allowed_by(const Limits& limits, int derivative, double excess, double rounding) noexcept {
  if (derivative == 1) return widened(limits.v_min, limits.v_max, limits.v_horizontal, excess, rounding);
  if (derivative == 2) return widened(limits.a_min, limits.a_max, limits.a_horizontal, excess, rounding);
  Vec3 most = limits.j_max;
  for (int a = 0; a < 3; ++a) {
    if (!(axis(most, a) > 0.0)) axis(most, a) = kAnyValue;
  }
  return widened(kZero, most, limits.j_horizontal, excess, rounding);
}

bool limits_jerk(const Limits& limits) noexcept {
  return limits.j_max.x > 0.0 || limits.j_max.y > 0.0 || limits.j_max.z > 0.0 || limits.j_horizontal > 0.0;
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
  const double norm = square_root(value.x * value.x + value.y * value.y) - allowed.horizontal;
  if (allowed.horizontal > 0.0 && norm > most.amount) most = {kHorizontalNorm, norm};
  return most;
}

}  // namespace tern
