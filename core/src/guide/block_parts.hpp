// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The connected parts of one block of 4 x 4 x 4 voxels. A wall thinner than a block may divide the block into parts on
// both sides, with no path between them.
#ifndef TERN_GUIDE_BLOCK_PARTS_HPP
#define TERN_GUIDE_BLOCK_PARTS_HPP

#include <cstdint>

#include "base/direction.hpp"
#include "tern/grid.hpp"

namespace tern {

/// Voxels of a block four voxels wide, which is a page: one bit for each place in the page.
using VoxelMask = std::uint64_t;

/// Sides of a block in the order -x, +x, -y, +y, -z, +z, and sets of them as bits.
constexpr int kSides = 6;
using SideMask = unsigned;
constexpr SideMask kAllSides = (1u << kSides) - 1;

/// The move across each side.
constexpr int kSideMove[kSides] = {direction(-1, 0, 0), direction(1, 0, 0),  direction(0, -1, 0),
                                   direction(0, 1, 0),  direction(0, 0, -1), direction(0, 0, 1)};

/// The move in the opposite direction.
constexpr int opposite(int move) {
  return kDirections - 1 - move;
}

/// The sides that a move crosses: one for each of its axes.
constexpr SideMask sides_of(int move) {
  const Voxel step = offset(move);
  const auto along = [](std::int32_t s, int axis) { return s == 0 ? 0u : 1u << (2 * axis + (s > 0 ? 1 : 0)); };
  return along(step.x, 0) | along(step.y, 1) | along(step.z, 2);
}

/// The free voxels of a block. Nothing is free outside the grid.
VoxelMask block_voxels(const Grid& grid, const Voxel& block) noexcept;

/// The voxels of `free` that faces connect to any of `seeds`.
VoxelMask connected(VoxelMask seeds, VoxelMask free) noexcept;

/// True if the free voxels are all connected.
bool one_part(VoxelMask free) noexcept;

/// The sides that the voxels touch.
SideMask sides_touched(VoxelMask voxels) noexcept;

/// The voxels of the block across a side that touch some of these voxels.
VoxelMask voxels_across(VoxelMask voxels, int side) noexcept;

}  // namespace tern

#endif
