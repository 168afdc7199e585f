// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_SEARCH_OPEN_LIST_HPP
#define TERN_SEARCH_OPEN_LIST_HPP

#include <cstdint>

#include "search/node_store.hpp"

namespace tern {

/// Order of expansion, total: least f = g + h first; among equals least h (the path that is further along); then least
/// voxel index. `tie` holds h, in units of 2^-20 voxel, above the voxel index.
struct OpenKey {
  Cost f;
  std::uint64_t tie;
};

constexpr OpenKey open_key(Cost g, Cost h, std::uint32_t voxel) {
  return {g + h, (h >> (kCostFraction - 20)) << 32 | voxel};
}
static_assert((octile({0, 0, 0}, {2047, 2047, 2047}) >> (kCostFraction - 20)) >> 32 == 0, "h fits its half of the tie");

constexpr bool before(const OpenKey& a, const OpenKey& b) {
  return a.f != b.f ? a.f < b.f : a.tie < b.tie;
}

/// Steps of one sweep (jump.hpp). They and the grid bound how far beyond a node's f its successors' can be.
constexpr std::int32_t kSweepSteps = 32;

/// Bins of f, a sixteenth of a voxel wide, in a ring that holds every f from a node's to its farthest successor's: a
/// jump is a sweep along three axes, one along two and a scan, and both its cost and what h grows by are its length at
/// most.
constexpr int kBinBits = 32;
constexpr std::int32_t kBinsPerVoxel = std::int32_t{1} << (kCostFraction - kBinBits);
constexpr std::uint32_t kBins =
    power_of_two(static_cast<std::uint32_t>(2 * (kMaxDimension + 4 * kSweepSteps) * kBinsPerVoxel));
constexpr std::int32_t kNoLink = -1;

/// An entry of a bin.
struct OpenLink {
  std::uint32_t node;
  std::int32_t next;  ///< in its bin, or in the list of links to use again; kNoLink at the end
};

/// An entry of the heap: OpenKey within a bin.
struct OpenEntry {
  std::uint64_t order;  ///< f's part within the bin, above h in units of 2^-20 voxel
  std::uint32_t voxel;
  std::uint32_t node;
};

/// The open list: what has the least f, to a sixteenth of a voxel, is in a 4-ary heap, which so is small and fits the
/// cache; everything beyond waits in bins. A better path to a node that is open enters it anew, and the entry that it
/// had is passed over when its turn comes.
struct OpenList {
  std::int32_t count;  ///< entries, in bins and heap together; kMaxOpen at most
  std::int32_t high;   ///< most entries at once so far
  std::int32_t heap_count;
  bool hole;                                ///< the heap's first entry was taken, and its place is not filled yet
  std::int32_t links_used;                  ///< links that were ever used; the rest is free
  std::int32_t unused;                      ///< first link to use again
  std::int32_t moving;                      ///< first link of the heap's bin that is not in the heap yet
  std::uint64_t bin;                        ///< f in bins: of the heap
  std::uint64_t groups[kBins / (64 * 64)];  ///< one bit a word of `busy` that is not 0
  std::uint64_t busy[kBins / 64];           ///< one bit a bin that holds something, valid where `groups` says so
  std::int32_t first[kBins];                ///< valid where `busy` says so
  OpenLink links[kMaxOpen];
  OpenEntry heap[kMaxOpen];
};

/// Empties the list; what is put in may not have a lesser f than `f`.
void open_reset(OpenList& open, Cost f) noexcept;

/// Puts the node in with this key, which precedes the one that it was in with, if any. False where the list is full.
bool open_put(OpenList& open, NodeStore& store, std::uint32_t node, const OpenKey& key) noexcept;

/// Brings what precedes everything else into the heap, in parts: false where more is to be done, or nothing is in.
bool open_ready(OpenList& open, const NodeStore& store, const Voxel& goal) noexcept;

/// Takes out the first node and tells its f. Only after open_ready; kMaxNodes where the entry is to be passed over.
std::uint32_t open_take(OpenList& open, NodeStore& store, Cost& f) noexcept;

}  // namespace tern

#endif
