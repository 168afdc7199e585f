// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Limits of real vehicles, and how much of them a motion uses.
#ifndef TERN_TESTS_SUPPORT_VEHICLE_LIMITS_HPP
#define TERN_TESTS_SUPPORT_VEHICLE_LIMITS_HPP

#include <cmath>

#include "support/random.hpp"
#include "tern/flatness.hpp"
#include "tern/request.hpp"

namespace tern_test {

/// From a loaded delivery quadrotor to a racer.
inline tern::Limits random_vehicle(Random& random) {
  const double lift = random.real(1.3, 6.0);
  const double speed = random.real(3.0, 20.0);
  tern::Limits limits{{speed, speed, 0.6 * speed}, {100.0, 100.0, 100.0}};
  limits.thrust_max = lift * tern::kGravity;
  limits.thrust_min = random.real(0.05, 0.5) * tern::kGravity;
  limits.tilt_tangent = std::tan(random.real(0.4, 1.35));
  limits.rate_max = random.real(2.0, 15.0);
  return limits;
}

inline double norm_of(const tern::Vec3& v) {
  return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

/// The largest part of a limit of the vehicle that a motion uses; of the least thrust, the limit over the vertical
/// thrust. A limit of 0 is none.
inline double vehicle_use(const tern::Limits& limits, const tern::Vec3& acceleration, const tern::Vec3& jerk) {
  const tern::Vec3 f{acceleration.x, acceleration.y, acceleration.z + tern::kGravity};
  const tern::Vec3 turn{jerk.y * f.z - jerk.z * f.y, jerk.z * f.x - jerk.x * f.z, jerk.x * f.y - jerk.y * f.x};
  const double thrust = norm_of(f);
  double use = f.z > 0.0 ? 0.0 : HUGE_VAL;
  if (limits.thrust_max > 0.0) use = std::fmax(use, thrust / limits.thrust_max);
  if (limits.thrust_min > 0.0) use = std::fmax(use, limits.thrust_min / f.z);
  if (limits.tilt_tangent > 0.0) use = std::fmax(use, std::hypot(f.x, f.y) / f.z / limits.tilt_tangent);
  if (limits.rate_max > 0.0) use = std::fmax(use, norm_of(turn) / (thrust * thrust) / limits.rate_max);
  return use;
}

}  // namespace tern_test

#endif
