// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A request's limits as the certifier reads them, by itself.
#ifndef TERN_PROVE_ALLOWED_HPP
#define TERN_PROVE_ALLOWED_HPP

#include "tern/request.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// The values that a velocity, an acceleration or a jerk may have: a convex set.
struct Allowed {
  Vec3 least;
  Vec3 most;
  double horizontal;  ///< 0: no limit
  // Of accelerations: the thrust is the value plus gravity.
  double thrust = 0.0;  ///< 0: no limit
  double slope = 0.0;   ///< horizontal over vertical thrust; 0: no limit
  double spare = 0.0;   ///< what the vertical thrust is granted besides
};

/// The values that the limits allow derivative 1, 2 or 3, widened by the relative `excess` and by `rounding`.
Allowed allowed_by(const Limits& limits, int derivative, double excess, double rounding) noexcept;

/// True if the jerk is limited on some axis, or its horizontal norm is.
bool limits_jerk(const Limits& limits) noexcept;

/// True if all points are allowed; their hull then is, too.
bool hull_allowed(const Allowed& allowed, const Vec3* points, int count) noexcept;

/// True if body rates are limited.
bool limits_turning(const Limits& limits) noexcept;

/// ProofReport::axis of the horizontal norm, of the thrust, and of the tilt.
constexpr int kHorizontalNorm = 3;
constexpr int kThrustNorm = 4;
constexpr int kTiltNorm = 5;

/// By how much a value is beyond what is allowed, on the axis where that is most. 0 on axis -1 if it is allowed.
struct Excess {
  int axis;
  double amount;
};
Excess excess_of(const Allowed& allowed, const Vec3& value) noexcept;

}  // namespace tern

#endif
