// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_GRID_LAYOUT_HPP
#define TERN_HOST_GRID_LAYOUT_HPP

#include "host/scenario.hpp"
#include "tern/grid.hpp"

namespace tern_host {

/// The grid that a scenario asks for: from the boundary's lower corner, as many voxels as cover the boundary. Where a
/// block sticks out of the boundary, or the unknown is solid, the grid is wider by the radius and a voxel on every
/// side, in whole voxels, so that obstacles beyond the boundary keep their distance; the boundary stays what it is.
/// Throws ScenarioError where the grid is beyond a compiled capacity.
tern::GridSpec lay_out_grid(const Scenario& scenario);

}  // namespace tern_host

#endif
