// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// RRT* and PRM as the Open Motion Planning Library has them, on the free voxels of a grid.
#ifndef TERN_BENCH_SAMPLING_HPP
#define TERN_BENCH_SAMPLING_HPP

#include <cstdint>
#include <vector>

#include "baselines/route.hpp"
#include "host/scenario.hpp"
#include "tern/grid.hpp"

namespace tern_bench {

enum class Sampler { kRrtStar, kPrm };

/// What a planner has at some time.
struct Snapshot {
  double time;  ///< seconds of wall-clock time since the query was put
  Route route;  ///< best so far
};

/// True where the program was built with the library.
bool has_sampling();

/// Runs a planner, with its default settings, on one query: the first snapshot is its first solution (or, where it has
/// none by the last of `times`, a route that was not found), the others what it has at each of `times`, ascending
/// seconds. A state is valid where its voxel is free; a motion where states half a voxel apart are. Seeded, but what is
/// found by a time depends on the machine. Empty without the library.
std::vector<Snapshot> run_sampler(Sampler sampler, const tern::Grid& grid, const tern_host::Scenario& scenario,
                                  std::uint32_t seed, const std::vector<double>& times);

}  // namespace tern_bench

#endif
