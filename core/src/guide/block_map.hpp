// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The map seen coarsely: cubes of voxels, each joined to the next one where free voxels meet across their common face.
// Whatever is connected in voxels is connected in blocks; the converse is not true. Made from the rows of the blocked
// layer when first looked at, 64 blocks along x at a time.
#ifndef TERN_GUIDE_BLOCK_MAP_HPP
#define TERN_GUIDE_BLOCK_MAP_HPP

#include <cstdint>

#include "base/direction.hpp"
#include "guide/block_parts.hpp"
#include "tern/grid.hpp"

namespace tern {

/// Blocks of the largest map, and words of 64 blocks along x. A map that is thin, or none of whose dimensions is a
/// multiple of four, may have more: it has no block map.
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

/// Of the cheapest path in an empty map.
constexpr GuideCost guide_octile(const Voxel& a, const Voxel& b) {
  const MoveCounts moves = octile_moves(a, b);
  return static_cast<GuideCost>(moves.space) * kGuideSpace + static_cast<GuideCost>(moves.plane) * kGuidePlane +
         static_cast<GuideCost>(moves.straight) * kGuideStraight;
}

/// A block, and what a search of blocks knows of it.
struct Block {
  /// In `flags`.
  static constexpr std::uint8_t kClosed = 1;  ///< the cheapest path is known
  static constexpr std::uint8_t kParts = 2;   ///< it is known whether the free voxels are in several parts
  static constexpr std::uint8_t kSplit = 4;   ///< they are
  /// In `sides`, besides one bit a side at which free voxels meet those of the block beyond.
  static constexpr std::uint8_t kFull = 1 << kSides;  ///< all voxels are free

  GuideCost distance;  ///< from the search's origin, by the best path found; kFar before one is
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

/// Prepares the map of a grid: nothing is made yet. False where the grid has too many blocks.
bool block_map_begin(BlockMap& map, const Grid& grid) noexcept;

/// Makes the block, with those beside it in its word.
void block_touch(BlockMap& map, const Grid& grid, const Voxel& block) noexcept;

/// Finds out whether the block's free voxels are all connected within it. Blocks of eight voxels count as connected.
void block_find_parts(BlockMap& map, const Grid& grid, const Voxel& block, Block& at) noexcept;

/// True where they are not. `at` is the block.
inline bool block_split(BlockMap& map, const Grid& grid, const Voxel& block, Block& at) noexcept {
  if ((at.flags & Block::kParts) == 0) block_find_parts(map, grid, block, at);
  return (at.flags & Block::kSplit) != 0;
}

/// Moves that lead from a block across some of its sides, along one axis or two: along two, one of the two blocks at
/// the corner must be joined to both and not be split. Makes the blocks that they lead to.
CellMask block_moves(BlockMap& map, const Grid& grid, const Voxel& block, SideMask sides) noexcept;

}  // namespace tern

#endif
