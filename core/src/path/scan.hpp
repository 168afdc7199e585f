// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Straight scans: from a voxel along one axis to the first jump point.
#ifndef TERN_PATH_SCAN_HPP
#define TERN_PATH_SCAN_HPP

#include "path/direction.hpp"
#include "tern/grid.hpp"

namespace tern {

/// The first voxel after `from` in the straight direction `move` that is the goal or has a forced neighbour, with
/// nothing blocked before it. The goal is free. False where an obstacle or the grid's face comes first. Reads the nine
/// rows around the line once: along x 64 voxels a word.
bool scan_straight(const Grid& grid, const Voxel& goal, const Voxel& from, int move, Voxel& found) noexcept;

}  // namespace tern

#endif
