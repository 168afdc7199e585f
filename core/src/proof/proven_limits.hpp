// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PROOF_PROVEN_LIMITS_HPP
#define TERN_PROOF_PROVEN_LIMITS_HPP

#include "tern/request.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// The values that a velocity, an acceleration or a jerk may have: a convex set.
struct Allowed {
  Vec3 least;
  Vec3 most;
  double horizontal;  ///< 0: no limit
};

/// The values that the limits allow, widened by kProofExcess and by `rounding`.
Allowed allowed_velocity(const Limits& limits, double rounding) noexcept;
Allowed allowed_acceleration(const Limits& limits, double rounding) noexcept;
Allowed allowed_jerk(const Limits& limits, double rounding) noexcept;

/// True if the jerk is limited on some axis, or its horizontal norm is.
bool limits_jerk(const Limits& limits) noexcept;

/// True if all points are allowed; their hull then is, too.
bool hull_allowed(const Allowed& allowed, const Vec3* points, int count) noexcept;

}  // namespace tern

#endif
