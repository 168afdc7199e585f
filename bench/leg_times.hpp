// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_LEG_TIMES_HPP
#define TERN_BENCH_LEG_TIMES_HPP

#include <vector>

#include "base/math.hpp"
#include "curve/hermite.hpp"
#include "tern/corridor.hpp"
#include "times/trapezoid.hpp"

namespace tern_bench {

/// The paper's allocation (Section 3.3.2): every leg of the corridor from rest to rest, seconds.
inline std::vector<double> leg_times(const tern::Corridor& corridor, const tern::Limits& limits) {
  std::vector<double> times;
  for (int i = 0; i < corridor.count; ++i) {
    const tern::Vec3 way = corridor.polyhedra[i].to - corridor.polyhedra[i].from;
    const double length = tern::length(way);
    times.push_back(length > 0.0 ? tern::trapezoid_time(length, limits_along(way, limits)) : tern::kMinDuration);
  }
  return times;
}

}  // namespace tern_bench

#endif
