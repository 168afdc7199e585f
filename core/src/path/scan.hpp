// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Straight scans: from a voxel along one axis to the first jump point, 64 voxels a step.
#ifndef TERN_PATH_SCAN_HPP
#define TERN_PATH_SCAN_HPP

#include "path/direction.hpp"
#include "path/turned.hpp"
#include "tern/grid.hpp"

namespace tern {

/// What scans read: the grid's own rows along x and its turned copies along y and z.
struct ScanMap {
  TurnedLayer along_y;
  TurnedLayer along_z;
};

/// Prepares scans of a grid, which must not change until they end.
void scan_reset(ScanMap& map, const Grid& grid) noexcept;

/// The first voxel after `from` in the straight direction `move` that is the goal or has a forced neighbour, with
/// nothing blocked before it. The goal is free. False where an obstacle or the grid's face comes first. Reads each word
/// of the nine rows around the line once at most.
bool scan_straight(ScanMap& map, const Grid& grid, const Voxel& goal, const Voxel& from, int move,
                   Voxel& found) noexcept;

}  // namespace tern

#endif
