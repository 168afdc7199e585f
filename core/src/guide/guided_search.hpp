// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The guided search: weighted A* over voxels, which closes each voxel once. Its heuristic comes from the search of
// blocks. It is fast, but not optimal. docs/search.md says what it finds and what bounds it.
#ifndef TERN_GUIDE_GUIDED_SEARCH_HPP
#define TERN_GUIDE_GUIDED_SEARCH_HPP

#include <cstdint>

#include "base/work.hpp"
#include "guide/block_search.hpp"
#include "guide/bucket_queue.hpp"
#include "guide/page_store.hpp"
#include "tern/grid.hpp"
#include "tern/path.hpp"
#include "tern/status.hpp"

namespace tern {

/// The most voxels that one guided search expands, and the most entries that it takes off its open list. Some entries
/// are skipped, or put in again because the guide has improved the heuristic. If these limits do not suffice, the guide
/// leads astray, and the optimal search is better.
constexpr std::uint32_t kGuidedExpansions = kMaxNodes / 4 < 8192 ? kMaxNodes / 4 : 8192;
constexpr std::uint32_t kGuidedTaken = 16 * kGuidedExpansions;

/// Buckets are a quarter of a voxel wide. Entries beyond the ring wait in the last bucket.
constexpr std::int32_t kGuidedBuckets = 1024;
constexpr std::int32_t kGuidedOpen = 3 * kMaxOpen < 32 * 1024 ? 3 * kMaxOpen : 32 * 1024;

/// Bound on the pieces of work of one guided search: entries taken off either open list.
constexpr std::uint32_t kGuidedBound = kBlocksTaken + kGuidedTaken;

/// A search between two free voxels. Plain data; needs no initialisation before guided_begin.
struct GuidedSearch {
  Voxel start;
  Voxel goal;
  std::uint32_t expanded;    ///< voxels
  std::uint32_t most;        ///< the most voxels that it may expand, given the length of the guide's path
  std::uint32_t taken;       ///< entries taken off `open`
  std::uint32_t entries;     ///< entries taken off either open list
  std::uint32_t guide_left;  ///< entries that the guide may still take before it stalls
  std::int32_t awaited;      ///< block that the guide has to close before the search of voxels goes on
  BlockSearch guide;
  BucketQueue<kGuidedBuckets, kGuidedOpen> open;
  PageStore store;
};

/// Opens the start. Both voxels must be free in the grid's blocked layer, which must not change until the search ends.
/// `small` as in block_map_begin. False if the grid has too many blocks for a guide.
bool guided_begin(GuidedSearch& search, const Grid& grid, const Voxel& start, const Voxel& goal,
                  bool small = false) noexcept;

constexpr std::uint32_t kGuideStallLimit = 4096;
/// True once the guide has taken kGuideStallLimit entries without reaching the start's block: the start may be walled
/// in. The search continues after guided_reopen().
inline bool guide_stalls(const GuidedSearch& search) noexcept {
  return search.guide_left == 0 && !block_closed(search.guide, search.guide.map.index(search.guide.target));
}

/// Opens the start again, with nothing else open. The guide then never stalls again.
void guided_reopen(GuidedSearch& search, const Grid& grid) noexcept;

/// Takes entries off the open lists, one a piece of work. kRunning if nothing is left of the slice, or once
/// guide_stalls() is true. At the end: kOk; kNoPath if no moves connect the two voxels; kNodesFull or kOpenFull if a
/// capacity or one of the limits above is exhausted, which proves nothing. Must not be called after the end.
Status guided_advance(GuidedSearch& search, const Grid& grid, Work& work) noexcept;

/// Appends the turning points of the path found, as search_extract() does. Call it once, after kOk.
Status guided_extract(GuidedSearch& search, const Grid& grid, int reserve, Path& path) noexcept;

}  // namespace tern

#endif
