// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_PAPER_WORLD_HPP
#define TERN_BENCH_PAPER_WORLD_HPP

#include <cstdint>
#include <vector>

#include "baselines/route.hpp"
#include "host/scenario.hpp"
#include "tern/grid.hpp"

namespace tern_bench {

/// A scenario's grid, filled and inflated, with its storage. Not to be copied: the grid points into the words.
class ScenarioGrid {
 public:
  /// Throws std::runtime_error where the scenario does not make a grid.
  explicit ScenarioGrid(const tern_host::Scenario& scenario);
  ScenarioGrid(const ScenarioGrid&) = delete;
  ScenarioGrid& operator=(const ScenarioGrid&) = delete;

  const tern::Grid& grid() const { return grid_; }

  /// The free voxel nearest to a world point, in rings of voxels around its own; false where there is none.
  bool nearest_free(const tern::Vec3& point, tern::Voxel& voxel) const;

  /// Voxel centres in the world frame, between the exact ends.
  std::vector<tern::Vec3> chain(const tern::Vec3& start, const std::vector<tern::Voxel>& voxels,
                                const tern::Vec3& goal) const;

  tern::Vec3 to_world(const tern::Vec3& local) const;

 private:
  std::vector<std::uint64_t> words_;
  tern::Grid grid_;
};

/// Least distance of a chain of points to any block, metres, sampled every 2 mm at most; infinite without blocks.
double clearance(const std::vector<tern::Vec3>& points, const tern_host::Scenario& scenario);

}  // namespace tern_bench

#endif
