// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PATH_BRESENHAM_HPP
#define TERN_PATH_BRESENHAM_HPP

#include "tern/grid.hpp"

namespace tern {

/// The paper's line of sight (Section 3.2.3): Bresenham's line from voxel to voxel in three dimensions, one voxel a
/// step along the longest axis, all of them free. It may pass between blocked voxels that touch at an edge or a corner:
/// for comparison only.
bool bresenham_free(const Grid& grid, const Voxel& a, const Voxel& b) noexcept;

}  // namespace tern

#endif
