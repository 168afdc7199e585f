// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PATH_NODE_STORE_HPP
#define TERN_PATH_NODE_STORE_HPP

#include <cstdint>

#include "path/direction.hpp"

namespace tern {

/// A voxel that the search generated. 32 bytes, and 8 of the table below.
struct SearchNode {
  Cost g;                  ///< cost of the best way found from the start
  std::uint32_t voxel;     ///< x + dims.x (y + dims.y z)
  std::uint32_t parent;    ///< node that the best way comes from by one jump; itself for the start
  CellMask arrivals;       ///< moves by which a way of cost g arrives here
  CellMask followed;       ///< moves that were followed from here at cost g
  std::uint32_t slot;      ///< where the table refers to this node
  std::int32_t open_slot;  ///< where the open list holds it; kNotOpen otherwise
};
static_assert(sizeof(SearchNode) == 32, "two nodes a cache line");

constexpr std::int32_t kNotOpen = -1;

/// The least power of two that holds `n`.
constexpr std::uint32_t power_of_two(std::uint32_t n) {
  std::uint32_t size = 1;
  while (size < n) size *= 2;
  return size;
}

/// At most half of the slots are ever used, so that a probe is short.
constexpr std::uint32_t kNodeSlots = power_of_two(2u * static_cast<std::uint32_t>(kMaxNodes));

/// All nodes of one search, found by voxel: an open-addressing table over a pool. The table is never cleared: a slot
/// counts only if it names a node of this search that names the slot in turn, so that it may begin with any bits.
struct NodeStore {
  std::uint32_t count;
  std::int32_t slot_bits;  ///< the table's first 2^slot_bits slots are in use
  SearchNode nodes[kMaxNodes];
  std::uint32_t slots[kNodeSlots];
};

/// Empties the store for a map of so many voxels; touches no array.
void store_reset(NodeStore& store, std::int64_t voxels) noexcept;

/// The node of a voxel, made with no arrivals, not open, where there is none yet; kMaxNodes where the store is full.
std::uint32_t store_find_or_add(NodeStore& store, std::uint32_t voxel) noexcept;

}  // namespace tern

#endif
