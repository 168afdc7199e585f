// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the guide knows about split blocks: the part in which each was entered, and whether other parts have been left
// out.
#ifndef TERN_GUIDE_SPLIT_BLOCKS_HPP
#define TERN_GUIDE_SPLIT_BLOCKS_HPP

#include "guide/block_map.hpp"
#include "guide/block_parts.hpp"
#include "tern/grid.hpp"

namespace tern {

/// The voxels of a block that the guide stands for: all free ones or, of a split block, the part that it entered. A
/// split block must be closed.
VoxelMask part_of(BlockMap& map, const Grid& grid, const Voxel& block) noexcept;

/// Enters a split block that is about to be closed: by its arrival or, if it has none, in its voxel at `place`. Returns
/// the sides across which the entered part meets a neighbour.
SideMask enter_part(BlockMap& map, const Grid& grid, const Voxel& block, int place) noexcept;

/// True if the guide has left out a part that it could have reached, of this closed block or of a closed neighbour.
/// In that case, the part that it entered in one of the two blocks touches a part of the other that it did not enter.
bool leaves_out(BlockMap& map, const Grid& grid, const Voxel& block) noexcept;

}  // namespace tern

#endif
