// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A coarse map: blocks of voxels. Two neighbouring blocks are joined if free voxels touch across their common face. If
// voxels are connected, so are their blocks; the converse is not true. Blocks are made from the rows of the blocked
// layer when a search first needs them, those of one word of voxels at a time.
#ifndef TERN_GUIDE_BLOCK_MAP_HPP
#define TERN_GUIDE_BLOCK_MAP_HPP

#include <cstdint>

#include "base/direction.hpp"
#include "guide/block_parts.hpp"
#include "tern/grid.hpp"

namespace tern {

/// Capacity for blocks, and for words of voxels along x in all rows of blocks: those of the largest map.
/// A thin map, or one whose dimensions are no multiples of four, may need more. It then has no block map.
constexpr std::int32_t kGuideBlocks = static_cast<std::int32_t>((kMaxCells + 63) / 64);
constexpr std::int32_t kBlockWords = static_cast<std::int32_t>((kMaxCells + 511) / 512);

/// Costs of paths over voxels and over blocks, in 256ths of a voxel's edge.
using GuideCost = std::uint32_t;
constexpr GuideCost kGuideStraight = 256;
constexpr GuideCost kGuidePlane = 362;
constexpr GuideCost kGuideSpace = 443;
constexpr GuideCost kFar = 0xFFFFFFFFu;

constexpr GuideCost guide_cost(int move) {
  return axes_of(move) == 1 ? kGuideStraight : (axes_of(move) == 2 ? kGuidePlane : kGuideSpace);
}

/// Cost of the cheapest path in an empty map.
constexpr GuideCost guide_octile(const Voxel& a, const Voxel& b) {
  const std::int32_t x = magnitude(b.x - a.x);
  const std::int32_t y = magnitude(b.y - a.y);
  const std::int32_t z = magnitude(b.z - a.z);
  const std::int32_t level = x > y ? x : y;
  const std::int32_t most = level > z ? level : z;
  const std::int32_t lower = x < y ? x : y;
  const std::int32_t least = lower < z ? lower : z;
  // The longest extent costs kGuideStraight a voxel. The middle one adds kSecond a voxel, and the least one kThird.
  constexpr std::int32_t kSecond = kGuidePlane - kGuideStraight;
  constexpr std::int32_t kThird = kGuideSpace - kGuidePlane;
  return static_cast<GuideCost>((static_cast<std::int32_t>(kGuideStraight) - kSecond) * most + kSecond * (x + y + z) +
                                (kThird - kSecond) * least);
}

/// A block's byte of BlockMap::sides has one bit for each side at which the block is joined to its neighbour, and one
/// of these kinds.
constexpr unsigned kBlockWhole = 0u << kSides;  ///< not all voxels are free, but the free ones are connected within it
constexpr unsigned kBlockFull = 1u << kSides;   ///< all voxels are free
constexpr unsigned kBlockSplit = 2u << kSides;  ///< the free voxels are not all connected within it
constexpr unsigned kBlockUnknown = 3u << kSides;  ///< whole or split
constexpr unsigned kBlockKinds = 3u << kSides;

/// A block in the search of blocks.
struct Block {
  GuideCost distance;  ///< cost from the search's origin, by the best path so far; kFar if there is none
  std::uint32_t link;  ///< lower bits: the moves from the block, and kBlockClosed; upper bits: the last move
                       ///< of the best path

  CellMask moves() const { return link & kAllCells; }
  int arrival() const { return static_cast<int>(link >> kDirections); }
  bool closed() const { return (link & cell_bit(kHere)) != 0; }
};
static_assert(sizeof(Block) == 8 && kDirections + 5 == 32, "eight a cache line");

/// The bit of Block::link that says that the cheapest path to the block and the moves from it are known.
constexpr std::uint32_t kBlockClosed = cell_bit(kHere);

/// The link of a block that is not closed.
constexpr std::uint32_t arrival_link(int move) {
  return static_cast<std::uint32_t>(move) << kDirections;
}

/// Widths of a block, as BlockMap::log.
constexpr int kSmallBlocks = 2;
constexpr int kLargeBlocks = 3;

/// Plain data; needs no initialisation before block_map_begin.
struct BlockMap {
  std::int32_t log;                            ///< a block is 2^log voxels wide: 2 or 3
  Voxel dims;                                  ///< in blocks
  std::int32_t last;                           ///< number of blocks in a word of voxels, minus one: 15 or 7
  std::int32_t words;                          ///< number of words of voxels in a row of blocks
  std::int32_t offsets[kDirections];           ///< the step of a block's index for each move
  std::int32_t beside[kSides];                 ///< the step of a block's index across each side
  std::uint64_t made[kBlockWords / 64 + 1];    ///< one bit for each word: its blocks are made
  std::uint64_t around[kBlockWords / 64 + 1];  ///< one bit for each word: its blocks and those around it are made
  std::uint8_t sides[kGuideBlocks];            ///< byte of each block, see kBlockWhole; x fastest; valid if it is made
  std::uint8_t entries[kGuideBlocks];          ///< for each closed split block: a voxel of the part that was entered
  Block blocks[kGuideBlocks];                  ///< valid if the block is made

  bool large() const { return log == kLargeBlocks; }
  Voxel block_of(const Voxel& v) const { return {v.x >> log, v.y >> log, v.z >> log}; }
  std::int32_t row(const Voxel& b) const { return b.y + dims.y * b.z; }
  std::int32_t index(const Voxel& b) const { return b.x + dims.x * row(b); }
  std::int32_t word(const Voxel& b) const { return (b.x >> (6 - log)) + words * row(b); }
  Block& at(const Voxel& b) { return blocks[index(b)]; }
  const Block& at(const Voxel& b) const { return blocks[index(b)]; }
  bool full(std::int32_t block) const { return (sides[block] & kBlockKinds) == kBlockFull; }
  SideMask joined(const Voxel& b) const { return sides[index(b)] & kAllSides; }
};

/// Prepares the map of a grid, without making any blocks. Blocks are large if the radius is; with `small`, they are
/// not. False if the grid has too many blocks.
bool block_map_begin(BlockMap& map, const Grid& grid, bool small = false) noexcept;

/// Makes the block and the others of its word of voxels.
void block_touch(BlockMap& map, const Grid& grid, const Voxel& block) noexcept;

/// Finds out whether a block of an unknown kind is split. Blocks eight voxels wide are never of that kind. Returns the
/// block's byte of `sides`.
unsigned block_find_parts(BlockMap& map, const Grid& grid, const Voxel& block) noexcept;

/// True if the block is split.
inline bool block_split(BlockMap& map, const Grid& grid, const Voxel& block) noexcept {
  unsigned sides = map.sides[map.index(block)];
  if (sides >= kBlockUnknown) sides = block_find_parts(map, grid, block);
  return sides >= kBlockSplit;
}

/// Moves from a block.
struct BlockMoves {
  CellMask moves;
  bool split_beside;  ///< one of the blocks across the sides is split
};

/// Moves from a block across the given sides, along one axis or two. For a move along two axes, one of the two blocks
/// at the corner must be joined to both ends and must not be split. Makes the blocks that the moves lead to.
BlockMoves block_moves(BlockMap& map, const Grid& grid, const Voxel& block, SideMask sides) noexcept;

// The blocks of one word of voxels along x, found by operations on words: 16 blocks four voxels wide, or 8 eight voxels
// wide.

/// BlockMap::sides of the blocks in a word of voxels: four bits for each block, at its lowest bit.
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
