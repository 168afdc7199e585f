// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A coarse map: blocks of voxels. Two neighbouring blocks are joined if free voxels touch across their common face. If
// voxels are connected, so are their blocks; the converse is not true. Blocks are made from the rows of the blocked
// layer when a search first needs them, 64 along x at a time.
#ifndef TERN_GUIDE_BLOCK_MAP_HPP
#define TERN_GUIDE_BLOCK_MAP_HPP

#include <cstdint>

#include "base/direction.hpp"
#include "guide/block_parts.hpp"
#include "tern/grid.hpp"

namespace tern {

/// Capacity for blocks, and for words of 64 blocks along x: those of the largest map. A thin map, or one whose
/// dimensions are no multiples of four, may need more. It then has no block map.
constexpr std::int32_t kGuideBlocks = static_cast<std::int32_t>((kMaxCells + 63) / 64);
constexpr std::int32_t kBlockWords = static_cast<std::int32_t>((kMaxCells + 511) / 512);

/// Costs on the guide's two levels: a 256th of a voxel's edge.
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
  const MoveCounts moves = octile_moves(a, b);
  return static_cast<GuideCost>(moves.space) * kGuideSpace + static_cast<GuideCost>(moves.plane) * kGuidePlane +
         static_cast<GuideCost>(moves.straight) * kGuideStraight;
}

/// A block, and what the search of blocks knows about it.
struct Block {
  /// In `flags`.
  static constexpr std::uint8_t kClosed = 1;  ///< the cheapest path is known
  static constexpr std::uint8_t kParts = 2;   ///< it is known whether the block is split
  static constexpr std::uint8_t kSplit = 4;   ///< it is split: its free voxels are not all connected within it
  /// In `sides`, in addition to one bit for each side at which the block is joined to its neighbour.
  static constexpr std::uint8_t kFull = 1 << kSides;  ///< all voxels are free

  GuideCost distance;  ///< cost from the search's origin, by the best path so far; kFar if there is none
  std::uint8_t sides;
  std::uint8_t parent;  ///< the move by which that path arrives
  std::uint8_t flags;

  bool full() const { return (sides & kFull) != 0; }
  bool closed() const { return (flags & kClosed) != 0; }
};
static_assert(sizeof(Block) == 8, "eight a cache line");

/// Plain data; needs no initialisation before block_map_begin.
struct BlockMap {
  std::int32_t log;                            ///< a block is 2^log voxels wide: 2 or 3
  Voxel dims;                                  ///< in blocks
  std::int32_t words;                          ///< of a row of blocks
  std::int32_t offsets[kDirections];           ///< what a move adds to a block's index
  std::uint64_t made[kBlockWords / 64 + 1];    ///< one bit a word
  std::uint64_t around[kBlockWords / 64 + 1];  ///< one bit a word: all words around it are made
  Block blocks[kGuideBlocks];                  ///< x fastest; valid where `made` says so

  Voxel block_of(const Voxel& v) const { return {v.x >> log, v.y >> log, v.z >> log}; }
  std::int32_t index(const Voxel& b) const { return b.x + dims.x * (b.y + dims.y * b.z); }
  Block& at(const Voxel& b) { return blocks[index(b)]; }
  const Block& at(const Voxel& b) const { return blocks[index(b)]; }
  std::int32_t word(const Voxel& b) const { return (b.x >> 6) + words * (b.y + dims.y * b.z); }
};

/// Prepares the map of a grid, without making any blocks. False if the grid has too many blocks.
bool block_map_begin(BlockMap& map, const Grid& grid) noexcept;

/// Makes the block and the others of its word.
void block_touch(BlockMap& map, const Grid& grid, const Voxel& block) noexcept;

/// Finds out whether the block is split. Blocks of eight voxels count as not split.
void block_find_parts(BlockMap& map, const Grid& grid, const Voxel& block, Block& at) noexcept;

/// True if the block is split. `at` is the block.
inline bool block_split(BlockMap& map, const Grid& grid, const Voxel& block, Block& at) noexcept {
  if ((at.flags & Block::kParts) == 0) block_find_parts(map, grid, block, at);
  return (at.flags & Block::kSplit) != 0;
}

/// Moves from a block across the given sides, along one axis or two. For a move along two axes, one of the two blocks
/// at the corner must be joined to both ends and must not be split. Makes the blocks that the moves lead to.
CellMask block_moves(BlockMap& map, const Grid& grid, const Voxel& block, SideMask sides) noexcept;

}  // namespace tern

#endif
