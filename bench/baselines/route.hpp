// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_ROUTE_HPP
#define TERN_BENCH_ROUTE_HPP

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tern/vec3.hpp"

namespace tern_bench {

/// What a front end found. World frame, metres; from the exact start to the exact goal.
struct Route {
  bool found = false;
  std::vector<tern::Vec3> points;
  std::uint64_t expanded = 0;  ///< nodes taken off the open list; 0 where there is none
};

inline double distance(const tern::Vec3& a, const tern::Vec3& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

/// Metres along a chain of points; 0 for fewer than two.
inline double length(const std::vector<tern::Vec3>& points) {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += tern_bench::distance(points[i - 1], points[i]);
  return sum;
}

}  // namespace tern_bench

#endif
