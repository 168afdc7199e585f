// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "proof/proven_limits.hpp"

#include "base/bounds.hpp"
#include "base/math.hpp"
#include "tern/proof.hpp"

namespace tern {
namespace {

/// The limits widened by kProofExcess and `rounding`. A lower limit of 0 stands for minus the upper limit.
Allowed widened(const Vec3& least, const Vec3& most, double horizontal, double rounding) {
  constexpr double kWider = 1.0 + kProofExcess;
  Allowed allowed{kWider * least, kWider * most, 0.0};
  for (int a = 0; a < 3; ++a) {
    if (!(axis(least, a) < 0.0)) axis(allowed.least, a) = -axis(allowed.most, a);
    axis(allowed.least, a) -= rounding;
    axis(allowed.most, a) += rounding;
  }
  if (horizontal > 0.0) allowed.horizontal = kWider * horizontal + 2.0 * rounding;
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

Allowed allowed_velocity(const Limits& limits, double rounding) noexcept {
  return widened(limits.v_min, limits.v_max, limits.v_horizontal, rounding);
}

Allowed allowed_acceleration(const Limits& limits, double rounding) noexcept {
  return widened(limits.a_min, limits.a_max, limits.a_horizontal, rounding);
}

Allowed allowed_jerk(const Limits& limits, double rounding) noexcept {
  const Bounds bounds = make_optional_bounds(limits.j_max, limits.j_horizontal);
  return widened(bounds.lower, bounds.upper, bounds.horizontal, rounding);
}

bool limits_jerk(const Limits& limits) noexcept {
  return limits_anything(make_optional_bounds(limits.j_max, limits.j_horizontal));
}

bool hull_allowed(const Allowed& allowed, const Vec3* points, int count) noexcept {
  for (int i = 0; i < count; ++i) {
    if (!is_allowed(allowed, points[i])) return false;
  }
  return true;
}

}  // namespace tern
