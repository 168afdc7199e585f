// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ten gates in a row at the limits: a plan's duration beside the best that is known.
#ifndef TERN_BENCH_PLANS_GATES_HPP
#define TERN_BENCH_PLANS_GATES_HPP

#include <cstdint>

namespace tern_bench {

struct GateTimes {
  double planned = 0.0;     ///< seconds; 0 without a plan
  double climbed = 0.0;     ///< the fastest plan that a climb over the velocities at the gates found
  double point_mass = 0.0;  ///< the least that a point mass without limits on jerk was found to need
};

/// Random gates, planned with a time weight; `rounds` trials of the climb.
GateTimes fly_gates(std::uint64_t seed, double time_weight, double tolerance, int rounds);

}  // namespace tern_bench

#endif
