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

/// The most steps of one sweep (jump.hpp). With the grid's size, this bounds how far a successor's f can exceed the
/// node's f.
constexpr std::int32_t kSweepSteps = 32;

/// Bins of f, a sixteenth of a voxel wide. They form a ring that holds every f from a node's to the largest of its
/// successors. A jump is a sweep along three axes, a sweep along two, and a straight jump; its cost and the growth of h
/// are each at most its length.
constexpr int kBinBits = 32;
constexpr std::int32_t kBinsPerVoxel = std::int32_t{1} << (kCostFraction - kBinBits);
constexpr std::uint32_t kBins =
    power_of_two(static_cast<std::uint32_t>(2 * (kMaxDimension + 4 * kSweepSteps) * kBinsPerVoxel));
constexpr std::int32_t kNoLink = -1;

/// An entry of a bin.
struct OpenLink {
  std::uint32_t node;
  std::int32_t next;  ///< next link in its bin, or in the list of links to reuse; kNoLink at the end
};

/// An entry of the heap: OpenKey within a bin.
struct OpenEntry {
  std::uint64_t order;  ///< f's part within the bin, above h in units of 2^-20 voxel
  std::uint32_t voxel;
  std::uint32_t node;
};

/// The open list. Entries with the least f, to a sixteenth of a voxel, are in a 4-ary heap, which is therefore small
/// and fits the cache. All other entries wait in bins. A better path to an open node adds another entry for it; the
/// outdated entry is skipped when its turn comes.
struct OpenList {
  std::int32_t count;  ///< entries in bins and heap together; at most kMaxOpen
  std::int32_t high;   ///< most entries at once so far
  std::int32_t heap_count;
  bool hole;                                ///< the heap's first entry was taken, and its place is not filled yet
  std::int32_t links_used;                  ///< links that have ever been used; the rest are free
  std::int32_t unused;                      ///< first link to reuse
  std::int32_t moving;                      ///< first link of the heap's bin that is not in the heap yet
  std::uint64_t bin;                        ///< the bin whose entries are in the heap: f in widths of a bin
  std::uint64_t groups[kBins / (64 * 64)];  ///< one bit for each word of `busy`: the word is not 0
  std::uint64_t busy[kBins / 64];           ///< one bit for each bin: it is not empty; valid if `groups` says so
  std::int32_t first[kBins];                ///< first link of each bin; valid if `busy` says so
  OpenLink links[kMaxOpen];
  OpenEntry heap[kMaxOpen];
};

/// Empties the list. Entries put in later may not have an f less than `f`.
void open_reset(OpenList& open, Cost f) noexcept;

/// Puts the node in with this key. If the node is in the list already, the new key must precede its old one. False if
/// the list is full.
bool open_put(OpenList& open, NodeStore& store, std::uint32_t node, const OpenKey& key) noexcept;

/// Brings the entries that precede all others into the heap, in parts. False if parts are left to do, or if the list is
/// empty.
bool open_ready(OpenList& open, const NodeStore& store, const Voxel& goal) noexcept;

/// Takes out the first node, and sets `f` to its f. Call only after open_ready() has returned true. kMaxNodes if the
/// entry is outdated and must be skipped.
std::uint32_t open_take(OpenList& open, NodeStore& store, Cost& f) noexcept;

}  // namespace tern

#endif
