// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which voxels of a block a view saw whole.
#ifndef TERN_MAP_CARVE_HPP
#define TERN_MAP_CARVE_HPP

#include <cstdint>

#include "map/projector.hpp"

namespace tern {

/// Rows and planes of a block, which is one word long along x.
constexpr std::int32_t kBlock = 8;

/// A word for each row of a block: [plane][row].
struct BlockWords {
  std::uint64_t words[kBlock][kBlock];
};

/// Adds to `free` the wanted voxels that the view saw whole, and maybe others that it saw whole. `first` is the block's
/// lowest voxel. From cubes of 8 voxels downwards: one that is decided as a whole is not divided.
void carve(const View& view, const Projector& projector, const Voxel& first, const BlockWords& wanted,
           BlockWords& free) noexcept;

}  // namespace tern

#endif
