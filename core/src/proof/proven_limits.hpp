// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PROOF_PROVEN_LIMITS_HPP
#define TERN_PROOF_PROVEN_LIMITS_HPP

#include "tern/request.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// What a velocity, an acceleration or a jerk may be: a convex set.
struct Allowed {
  Vec3 least;
  Vec3 most;
  double horizontal;  ///< 0: no limit
};

/// With kProofExcess, and `rounding` on top.
Allowed allowed_velocity(const Limits& limits, double rounding) noexcept;
Allowed allowed_acceleration(const Limits& limits, double rounding) noexcept;
Allowed allowed_jerk(const Limits& limits, double rounding) noexcept;

/// True where some jerk is not allowed.
bool limits_jerk(const Limits& limits) noexcept;

/// True where all points are allowed, and so their hull.
bool hull_allowed(const Allowed& allowed, const Vec3* points, int count) noexcept;

}  // namespace tern

#endif
