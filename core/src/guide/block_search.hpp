// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The guide: A* over blocks, from the goal towards the start. It continues whenever the search of voxels comes to a
// block that it has not closed yet.
#ifndef TERN_GUIDE_BLOCK_SEARCH_HPP
#define TERN_GUIDE_BLOCK_SEARCH_HPP

#include <cstdint>

#include "guide/block_map.hpp"
#include "guide/bucket_queue.hpp"
#include "tern/status.hpp"

namespace tern {

/// Buckets a voxel wide. The ring holds every f from a block's to its successors'.
constexpr std::int32_t kBlockBuckets = 64;
constexpr std::int32_t kBlockOpen = kMaxOpen;

/// Bound on the pieces of work of the guide. Each block is closed once and then opens at most the 18 blocks that it
/// leads to. Of two neighbours, only the one that is closed first opens the other. So there are at most 9 entries a
/// block, plus the first entry. The bound is about twice that. This leaves room for the piece that finds the list
/// empty, and for the piece in which the guided search finds that its limit is reached.
constexpr std::uint32_t kBlocksTaken = 18u * static_cast<std::uint32_t>(kGuideBlocks) + 1u;

/// Plain data; needs no initialisation before block_search_begin.
struct BlockSearch {
  Voxel origin;  ///< voxel that the search begins at
  Voxel target;  ///< block that it heads for
  bool lost;     ///< it has left out parts of split blocks
  GuideCost f;   ///< f of the last closed block, rounded down to a voxel; no open block has less
  BlockMap map;
  BucketQueue<kBlockBuckets, kBlockOpen> open;
};

/// Opens the block of the voxel `from`. Both voxels must be free. `small` as in block_map_begin. False if the grid has
/// no block map.
bool block_search_begin(BlockSearch& search, const Grid& grid, const Voxel& from, const Voxel& towards,
                        bool small = false) noexcept;

/// Takes one entry off the open list. kRunning; kNoPath if no entry is left, which proves that there is no path.
/// kNodesFull if no entry is left but the search has left out parts of split blocks, which proves nothing. kOpenFull.
Status block_search_take(BlockSearch& search, const Grid& grid) noexcept;

/// True once the cheapest path to the block is known.
inline bool block_closed(const BlockSearch& search, std::int32_t index) noexcept {
  return search.map.blocks[index].closed();
}

}  // namespace tern

#endif
