// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Trajectories and requests for tests of yaw plans.
#ifndef TERN_TESTS_SUPPORT_YAW_CASE_HPP
#define TERN_TESTS_SUPPORT_YAW_CASE_HPP

#include <cmath>
#include <vector>

#include "support/random.hpp"
#include "tern/yaw.hpp"

namespace tern_test {

inline tern::Heading heading(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// At rest at the origin for `duration` seconds.
inline tern::Trajectory hover(double duration) {
  tern::Trajectory trajectory{};
  trajectory.count = 1;
  trajectory.segments[0].duration = duration;
  return trajectory;
}

/// Straight at constant speed through the points, for `seconds` each.
inline tern::Trajectory polyline(const std::vector<tern::Vec3>& points, double seconds) {
  tern::Trajectory trajectory{};
  trajectory.count = static_cast<int>(points.size()) - 1;
  for (int s = 0; s < trajectory.count; ++s) {
    const tern::Vec3& a = points[static_cast<std::size_t>(s)];
    const tern::Vec3& b = points[static_cast<std::size_t>(s) + 1];
    trajectory.segments[s].duration = seconds;
    for (int i = 0; i <= tern::kDegree; ++i) {
      const double u = static_cast<double>(i) / tern::kDegree;
      trajectory.segments[s].points[i] = {a.x + u * (b.x - a.x), a.y + u * (b.y - a.y), a.z + u * (b.z - a.z)};
    }
  }
  return trajectory;
}

/// Control points at random: turns, loops, cusps and reversals.
inline tern::Trajectory tangle(Random& random) {
  tern::Trajectory trajectory{};
  trajectory.count = random.integer(1, 6);
  trajectory.origin = {random.real(-10.0, 10.0), random.real(-10.0, 10.0), 0.0};
  tern::Vec3 last{0.0, 0.0, 0.0};
  for (int s = 0; s < trajectory.count; ++s) {
    tern::Segment& segment = trajectory.segments[s];
    segment.duration = std::exp(random.real(-2.0, 2.5));
    const double width = random.chance(0.2) ? 0.0 : 3.0;  // some move straight up or stay
    for (tern::Vec3& point : segment.points) {
      point = {last.x + random.real(-width, width), last.y + random.real(-width, width), random.real(-1.0, 1.0)};
    }
    segment.points[0] = last;
    last = segment.points[tern::kDegree];
  }
  return trajectory;
}

inline tern::Trajectory tangle_at(Random& random, const tern::Vec3& origin) {
  tern::Trajectory trajectory = tangle(random);
  trajectory.origin = origin;
  return trajectory;
}

}  // namespace tern_test

#endif
