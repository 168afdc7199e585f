// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_SUPPORT_RANDOM_CORRIDOR_HPP
#define TERN_TESTS_SUPPORT_RANDOM_CORRIDOR_HPP

#include <algorithm>
#include <cmath>
#include <vector>

#include "host/corridor_programme.hpp"
#include "support/qp_random.hpp"

namespace tern_test {

/// A walk of boxes that overlap, with segment durations up to `ratio` apart.
inline tern_host::CorridorCase random_corridor(Random& random, int segments, double ratio) {
  tern_host::CorridorCase c;
  c.segments = segments;
  c.v_max = 1e6;
  c.a_max = 1e9;
  c.waypoints.push_back({0.0, 0.0, 0.0});
  for (int s = 0; s < segments; ++s) {
    const tern::Vec3 from = c.waypoints.back();
    const tern::Vec3 way = random_unit(random);
    const double length = random.real(0.5, 3.0);
    const tern::Vec3 to{from.x + length * way.x, from.y + length * way.y, from.z + length * way.z};
    c.waypoints.push_back(to);
    c.durations.push_back(std::pow(ratio, random.unit()));
    std::vector<tern::Halfspace> planes;
    for (const double side : {1.0, -1.0}) {
      const double margin = random.real(0.05, 0.6);
      planes.push_back({{side, 0, 0}, std::max(side * from.x, side * to.x) + margin});
      planes.push_back({{0, side, 0}, std::max(side * from.y, side * to.y) + margin});
      planes.push_back({{0, 0, side}, std::max(side * from.z, side * to.z) + margin});
    }
    c.planes.push_back(planes);
  }
  c.start[0] = c.waypoints.front();
  c.goal = c.waypoints.back();
  return c;
}

}  // namespace tern_test

#endif
