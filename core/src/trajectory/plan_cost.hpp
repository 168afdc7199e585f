// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a plan costs: its snap against its duration.
#ifndef TERN_TRAJECTORY_PLAN_COST_HPP
#define TERN_TRAJECTORY_PLAN_COST_HPP

#include "base/bounds.hpp"
#include "base/math.hpp"
#include "tern/request.hpp"

namespace tern {

/// The largest value along an axis that the bounds allow.
inline double largest_reach(const Bounds& bounds) noexcept {
  const double wide = larger(bounds.upper.x, bounds.upper.y);
  return larger(bounds.upper.z, bounds.horizontal > 0.0 ? smaller(wide, bounds.horizontal) : wide);
}

/// The time weight with its unit, m^2/s^8: flying at limits v and a takes times of v / a and jerks and snaps that go
/// with them. `weight`: Request::time_weight.
inline double snap_rate(const MotionLimits& limits, double weight) noexcept {
  const double v = largest_reach(limits.velocity);
  const double a = largest_reach(limits.acceleration);
  const double snap = (a / v) * (a / v) * a;
  return weight * (snap * snap);
}

/// Cost in m^2/s^7 of a plan that is stretched by a factor: snap falls with its seventh power. `rate` as above;
/// `duration` in seconds, before the stretch.
inline double plan_cost(double snap, double rate, double duration, double factor) noexcept {
  return snap / seventh_power(factor) + rate * factor * duration;
}

/// The factor of least cost: where 7 snap s^-8 = rate duration.
inline double cheapest_stretch(double snap, double rate, double duration) noexcept {
  return square_root(square_root(square_root(7.0 * snap / (rate * duration))));
}

}  // namespace tern

#endif
