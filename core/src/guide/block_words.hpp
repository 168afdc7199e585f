// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The blocks of one word of voxels along x, found by operations on words: 16 blocks of four voxels, or 8 of eight.
#ifndef TERN_GUIDE_BLOCK_WORDS_HPP
#define TERN_GUIDE_BLOCK_WORDS_HPP

#include <cstdint>

#include "guide/block_map.hpp"

namespace tern {

/// BlockMap::sides of the blocks in a word of voxels: four bits each at the block's lowest bit.
struct WordSides {
  std::uint64_t low;   ///< sides 0 to 3
  std::uint64_t high;  ///< sides 4 and 5, and the kind

  /// One byte for each of eight blocks, from the given block on.
  std::uint64_t bytes(std::int32_t block, int log) const {
    if (log == kLargeBlocks) return low | high << 4;
    return spread(low >> 4 * block) | spread(high >> 4 * block) << 4;
  }
  /// Spreads eight half-bytes to one byte each.
  static std::uint64_t spread(std::uint64_t bits) {
    bits &= 0xFFFFFFFFu;
    bits = (bits | bits << 16) & 0x0000FFFF0000FFFFu;
    bits = (bits | bits << 8) & 0x00FF00FF00FF00FFu;
    return (bits | bits << 4) & 0x0F0F0F0F0F0F0F0Fu;
  }
};
static_assert(kSides == 6 && kBlockFull == 1u << 6 && kBlockUnknown == 3u << 6, "two halves of a byte");

/// The sides of all blocks in the word of voxels that holds this block. `log` as in BlockMap.
WordSides read_block_word(const Grid& grid, int log, const Voxel& block) noexcept;

}  // namespace tern

#endif
