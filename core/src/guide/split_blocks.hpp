// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the guide knows about split blocks: which of its parts each one was entered in, and whether other parts have
// been left out.
#ifndef TERN_GUIDE_SPLIT_BLOCKS_HPP
#define TERN_GUIDE_SPLIT_BLOCKS_HPP

#include "guide/block_map.hpp"
#include "guide/block_parts.hpp"
#include "tern/grid.hpp"

namespace tern {

/// The voxels of a block that the guide stands for: all free ones or, of a split block, the part that it entered. A
/// split block must be closed.
VoxelMask part_of(BlockMap& map, const Grid& grid, const Voxel& block) noexcept;

/// Enters a split block that is about to be closed, by its arrival, or in its voxel at `place` if it has none. The
/// sides across which the part entered meets a neighbour.
SideMask enter_part(BlockMap& map, const Grid& grid, const Voxel& block, int place) noexcept;

/// True if a part that touches this closed block, or a part of this block, has been left out: beside it is a closed
/// block that leads there, and one of the two is split.
bool leaves_out(BlockMap& map, const Grid& grid, const Voxel& block) noexcept;

}  // namespace tern

#endif
