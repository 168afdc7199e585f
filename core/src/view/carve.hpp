// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds the voxels of a block that a view sees whole.
#ifndef TERN_VIEW_CARVE_HPP
#define TERN_VIEW_CARVE_HPP

#include <cstdint>

#include "view/projector.hpp"

namespace tern {

/// Rows and planes of a block. Along x, a block is one word long.
constexpr std::int32_t kBlock = 8;

/// A word for each row of a block: [plane][row].
struct BlockWords {
  std::uint64_t words[kBlock][kBlock];
};

/// Cubes of a block, a bit each; along x, a block is eight of them long.
using CubeBits = std::uint8_t;
constexpr CubeBits kAllCubes = 0xff;

/// The part of a block that one call carves: whether the call begins the block, and the cubes that it may divide.
struct CarvePart {
  bool begins;
  CubeBits cubes;
};

/// Adds to `free` all wanted voxels that the view sees whole; it may add others that the view sees whole. `first` is
/// the block's lowest voxel. Begins with cubes of 8 x 8 x 8 voxels and divides only those that cannot be decided as a
/// whole. `left` becomes the cubes that another call must divide. Returns its cost, in instructions (see Work).
std::uint32_t carve(const View& view, const Projector& projector, const Voxel& first, const BlockWords& wanted,
                    BlockWords& free, const CarvePart& part, CubeBits& left) noexcept;

}  // namespace tern

#endif
