// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_MAP_SCENARIO_GRID_HPP
#define TERN_HOST_MAP_SCENARIO_GRID_HPP

#include <cstdint>
#include <vector>

#include "host/scenario.hpp"
#include "tern/grid.hpp"

namespace tern_host {

/// Whether the scenario knows nothing of a voxel: it is no obstacle, there are OctoMaps, and none says that all of it
/// is free. Without an OctoMap everything is known.
bool is_unknown(const Scenario& scenario, const tern::Grid& grid, const tern::Voxel& voxel);

/// Marks the blocks, the keep-outs that are marked and, where the scenario takes the unknown for solid, what is not
/// known. The grid is bound and empty; not inflated afterwards. kOk, or what the grid says of a block.
tern::Status fill_grid(const Scenario& scenario, tern::Grid& grid);

/// A scenario's map as the planner gets it, and how much of it is what. Counted are the voxels within the boundary.
struct GridMap {
  /// Throws ScenarioError where the grid does not fit.
  explicit GridMap(const Scenario& scenario);

  tern::Status status;                 ///< of the grid; nothing below has a value unless it is kOk
  tern::Field field;                   ///< that is wrong
  tern::Grid grid;                     ///< inflated
  std::vector<std::uint64_t> unknown;  ///< a bit a voxel, x fastest
  tern::Voxel begin{0, 0, 0};          ///< the voxels within the boundary: from here
  tern::Voxel end{0, 0, 0};            ///< to before here
  std::int64_t voxels = 0;
  std::int64_t occupied_count = 0;  ///< known obstacles
  std::int64_t unknown_count = 0;
  std::int64_t blocked_count = 0;  ///< where the robot's centre may not be

  bool is_unknown(const tern::Voxel& voxel) const;

 private:
  std::size_t index(const tern::Voxel& voxel) const;
  void find_unknown(const Scenario& scenario);

  std::vector<std::uint64_t> words_;
};

}  // namespace tern_host

#endif
