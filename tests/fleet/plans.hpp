// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans for the tests of fleets, and where a vehicle is that flies one, by arithmetic of the tests' own.
#ifndef TERN_TESTS_FLEET_PLANS_HPP
#define TERN_TESTS_FLEET_PLANS_HPP

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "support/random.hpp"
#include "tern/track.hpp"
#include "tern/trajectory.hpp"

namespace tern_test {

inline constexpr std::int64_t kSecond = 1'000'000'000;

/// A plan that only waits at a place.
inline tern::Trajectory resting(const tern::Vec3& place, std::int64_t begin) {
  tern::Trajectory plan{};
  plan.begin = begin;
  plan.count = 1;
  plan.origin = place;
  plan.segments[0].duration = 1.0;
  return plan;
}

/// A straight plan from rest to rest, in `seconds`.
inline tern::Trajectory straight(const tern::Vec3& from, const tern::Vec3& to, std::int64_t begin, double seconds) {
  tern::Trajectory plan = resting(from, begin);
  plan.segments[0].duration = seconds;
  for (int k = 4; k < tern::kControlPoints; ++k) {
    plan.segments[0].points[k] = {to.x - from.x, to.y - from.y, to.z - from.z};
  }
  return plan;
}

/// Any curve of `count` segments that ends at rest, within `reach` metres of its origin.
inline tern::Trajectory wild(Random& random, int count, double reach) {
  tern::Trajectory plan{};
  plan.begin = random.integer(-1000, 1000) * kSecond / 7;
  plan.count = count;
  plan.origin = {random.real(-1e4, 1e4), random.real(-1e4, 1e4), random.real(-1e2, 1e2)};
  tern::Vec3 joint{};
  for (int s = 0; s < count; ++s) {
    plan.segments[s].duration = random.real(0.05, 8.0);
    for (int k = 0; k < tern::kControlPoints; ++k) {
      const bool rests = s + 1 == count && k > 4;
      if (k > 0 && !rests) joint = {random.real(-reach, reach), random.real(-reach, reach), random.real(-reach, reach)};
      plan.segments[s].points[k] = joint;
    }
  }
  return plan;
}

/// A Bezier curve of degree 7 by its Bernstein polynomials.
inline tern::Vec3 curve_at(const tern::Vec3* points, double u) {
  static constexpr double kChoose[8] = {1, 7, 21, 35, 35, 21, 7, 1};
  tern::Vec3 sum{};
  for (int k = 0; k < 8; ++k) {
    const double share = kChoose[k] * std::pow(u, k) * std::pow(1.0 - u, 7 - k);
    sum = {sum.x + share * points[k].x, sum.y + share * points[k].y, sum.z + share * points[k].z};
  }
  return sum;
}

/// Where the pieces lead `seconds` after their beginning: at rest before it and behind their end.
template <typename Piece>
tern::Vec3 place_at(const Piece* pieces, int count, double seconds) {
  double left = std::max(seconds, 0.0);
  for (int p = 0; p < count; ++p) {
    if (left <= pieces[p].duration) return curve_at(pieces[p].points, left / pieces[p].duration);
    left -= pieces[p].duration;
  }
  return pieces[count - 1].points[7];
}

/// Relative to the plan's origin, at a time of the plan's clock.
inline tern::Vec3 place_at(const tern::Trajectory& plan, std::int64_t now) {
  return place_at(plan.segments, plan.count, 1e-9 * static_cast<double>(now - plan.begin));
}

inline double between(const tern::Vec3& a, const tern::Vec3& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

}  // namespace tern_test

#endif
