// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PATH_OPEN_LIST_HPP
#define TERN_PATH_OPEN_LIST_HPP

#include <cstdint>

#include "path/node_store.hpp"

namespace tern {

/// Order of expansion, total: least f = g + h first; among equals least h (the way that is further along); then least
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

/// The open list: a 4-ary heap of fixed capacity, each node in it once at most. Nodes know their place in it, so that a
/// better way moves an entry and never adds one.
struct OpenList {
  std::int32_t count;
  std::int32_t high;  ///< most entries at once so far
  OpenKey keys[kMaxHeap];
  std::uint32_t owners[kMaxHeap];
};

void open_reset(OpenList& open) noexcept;

/// Puts the node in with this key, or moves it up to it where it is in with a later one. False where the list is full.
bool open_put(OpenList& open, NodeStore& store, std::uint32_t node, const OpenKey& key) noexcept;

/// Takes out the first node; the list must not be empty.
std::uint32_t open_take(OpenList& open, NodeStore& store) noexcept;

}  // namespace tern

#endif
