// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_LEG_TIMES_HPP
#define TERN_BENCH_LEG_TIMES_HPP

#include <cmath>
#include <vector>

#include "curve/hermite.hpp"
#include "tern/corridor.hpp"
#include "times/trapezoid.hpp"

namespace tern_bench {

/// The paper's allocation (Section 3.3.2): every leg of the corridor from rest to rest, seconds.
inline std::vector<double> leg_times(const tern::Corridor& corridor, const tern::Limits& limits) {
  std::vector<double> times;
  for (int i = 0; i < corridor.count; ++i) {
    const tern::Vec3& from = corridor.polyhedra[i].from;
    const tern::Vec3& to = corridor.polyhedra[i].to;
    const tern::Vec3 way{to.x - from.x, to.y - from.y, to.z - from.z};
    const double length = std::hypot(way.x, way.y, way.z);
    times.push_back(length > 0.0 ? tern::trapezoid_time(length, limits_along(way, limits)) : tern::kMinDuration);
  }
  return times;
}

}  // namespace tern_bench

#endif
