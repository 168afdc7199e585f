// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_SEARCH_NODE_STORE_HPP
#define TERN_SEARCH_NODE_STORE_HPP

#include <cstdint>

#include "base/direction.hpp"

namespace tern {

/// A voxel that the search generated. Takes 32 bytes, and 8 bytes of the table in NodeStore.
struct SearchNode {
  Cost g;                ///< cost of the best path found from the start
  std::int16_t x, y, z;  ///< the voxel
  std::uint16_t open;    ///< 1 while the open list holds it, 0 otherwise
  std::uint32_t voxel;   ///< x + dims.x (y + dims.y z)
  std::uint32_t parent;  ///< node that the best path comes from by one jump; itself for the start
  CellMask arrivals;     ///< moves by which a path of cost g arrives here
  CellMask followed;     ///< moves that were followed from here at cost g

  Voxel at() const { return {x, y, z}; }
};
static_assert(sizeof(SearchNode) == 32 && kMaxDimension <= INT16_MAX, "two nodes a cache line");

/// The least power of two that holds `n`.
constexpr std::uint32_t power_of_two(std::uint32_t n) {
  std::uint32_t size = 1;
  while (size < n) size *= 2;
  return size;
}

/// A page is a cube of 4 x 4 x 4 voxels, from multiples of 4 on. These are its coordinates, and a voxel's place in it.
constexpr Voxel page_coordinates(const Voxel& v) {
  return {v.x >> 2, v.y >> 2, v.z >> 2};
}
constexpr int place_in_page(const Voxel& v) {
  return (v.x & 3) | (v.y & 3) << 2 | (v.z & 3) << 4;
}
constexpr Voxel voxel_in_page(const Voxel& page, int place) {
  return {page.x * 4 + (place & 3), page.y * 4 + (place >> 2 & 3), page.z * 4 + (place >> 4)};
}

/// The upper bits of multiplicative hashing by the golden ratio: a number below `count` for a page.
constexpr std::uint32_t page_hash(const Voxel& page, std::uint32_t count) {
  const auto key = static_cast<std::uint32_t>(page.x | page.y << 10 | page.z << 20);
  return static_cast<std::uint32_t>(std::uint64_t{key * 0x9E3779B1u} * count >> 32);
}

/// Slots that the voxels of a page share.
constexpr std::uint32_t kPageSlots = 64;

/// At most half of the slots are ever used, so that a probe is short.
constexpr std::uint32_t kNodeSlots = power_of_two(2u * static_cast<std::uint32_t>(kMaxNodes));
static_assert(kNodeSlots >= kPageSlots && kMaxNodes < INT32_MAX, "a slot is a node's number and one");

/// All nodes of one search, found by voxel: an open-addressing table over a pool. Voxels of one page have their
/// slots side by side, since a search asks for neighbours. The 64 slots of a page are cleared when they are first
/// looked at, so that the cost of a search depends only on the voxels that it visits.
struct NodeStore {
  std::uint32_t count;
  std::uint32_t nx, ny;                                     ///< voxels of the grid along x and y
  std::uint64_t cleared[kNodeSlots / kPageSlots / 64 + 1];  ///< one bit for 64 slots
  std::uint32_t slots[kNodeSlots];                          ///< 0 if free, otherwise 1 + the node
  SearchNode nodes[kMaxNodes];
};

/// Empties the store for a grid of these dimensions. Writes only one bit for 64 slots.
void store_reset(NodeStore& store, const Voxel& dims) noexcept;

/// The node of a voxel. If there is none yet, makes one that has no arrivals and is not open. kMaxNodes if the store is
/// full.
std::uint32_t store_find_or_add(NodeStore& store, const Voxel& voxel) noexcept;

}  // namespace tern

#endif
