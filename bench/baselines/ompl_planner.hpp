// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// OMPL's sampling planners over a Tern grid, as yardsticks. Host only; the core knows nothing of it.
#ifndef TERN_BENCH_OMPL_PLANNER_HPP
#define TERN_BENCH_OMPL_PLANNER_HPP

#include <cstdint>
#include <vector>

#include "tern/grid.hpp"

namespace tern_bench {

enum class OmplAlgorithm : std::uint8_t { kRrtStar, kPrm };

struct OmplQuery {
  OmplAlgorithm algorithm;
  tern::Vec3 start;           ///< world frame, inside the boundary
  tern::Vec3 goal;            ///< likewise
  std::vector<double> times;  ///< seconds, ascending, one at least: when to look at what there is
  std::uint32_t seed;         ///< > 0; OMPL's clock still decides how many samples a run takes
};

struct OmplResult {
  bool solved = false;
  double seconds = 0.0;          ///< since the query was put, wall clock
  double length = 0.0;           ///< metres
  std::vector<tern::Vec3> path;  ///< world frame, start and goal included
};

/// Plans for a point in the union of the grid's free voxels (blocked layer up to date), in which lines are walked voxel
/// by voxel, not sampled. A line keeps no margin and may pass through an edge between free voxels: OMPL is allowed more
/// than Tern's own lines of sight are. All of OMPL's parameters are its defaults.
///
/// Returns the first solution (not solved where the last time came before it), then the best at each of the times: RRT*
/// goes on with its tree, PRM with its road map.
std::vector<OmplResult> ompl_plan(const tern::Grid& grid, const OmplQuery& query);

/// True where all voxels that the segment from a to b (local frame) passes through are free.
bool voxels_free(const tern::Grid& grid, const tern::Vec3& a, const tern::Vec3& b);

}  // namespace tern_bench

#endif
