// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_GUIDE_PAGE_STORE_HPP
#define TERN_GUIDE_PAGE_STORE_HPP

#include <cstdint>

#include "guide/block_map.hpp"
#include "search/node_store.hpp"

namespace tern {

/// Capacity for pages of one search of voxels. In most maps, 8192 expansions (guided_search.hpp) need some hundreds of
/// pages.
constexpr std::int32_t kGuidePages = kMaxNodes / 8 < 4096 ? kMaxNodes / 8 : 4096;
constexpr std::uint32_t kStoreSlots = power_of_two(2u * static_cast<std::uint32_t>(kGuidePages));

/// The paths to 4 x 4 x 4 voxels, and the carrot for all of them.
struct Page {
  std::uint64_t reached;     ///< one bit for each voxel, by its place: a path is known
  std::uint64_t closed;      ///< one bit for each voxel: it was expanded
  Voxel at;                  ///< the page's coordinates: voxels / 4
  Voxel carrot;              ///< voxel to head for; valid if `heads`
  GuideCost rest;            ///< heuristic from the carrot to the goal, or from the page if it has no carrot yet
  bool heads;                ///< the page has a carrot: the guide has closed its block
  std::uint8_t arrival[64];  ///< for each voxel, the move by which the best path reaches it
  GuideCost cost[64];        ///< cost of the best path to each voxel
};

/// The pages of one search, found by their coordinates: an open-addressing table over a pool.
struct PageStore {
  std::int32_t count;
  std::uint16_t slots[kStoreSlots];  ///< 0 if free, otherwise 1 + the page
  Page pages[kGuidePages];
};
static_assert(kGuidePages < 65535, "a slot is a page's number and one");

/// Empties the store; clears the slots, 16 KB at most.
inline void page_store_reset(PageStore& store) noexcept {
  store.count = 0;
  for (std::uint16_t& slot : store.slots) slot = 0;
}

/// The page of a voxel. Makes one, with no voxel reached, if there is none yet; kGuidePages if the store is full.
inline std::int32_t page_find_or_add(PageStore& store, const Voxel& voxel) noexcept {
  const Voxel at = page_coordinates(voxel);
  std::uint32_t slot = page_hash(at, kStoreSlots);
  // Ends at a free slot at the latest, because at most half of the slots are used.
  for (; store.slots[slot] != 0; slot = (slot + 1) % kStoreSlots) {
    const std::int32_t held = store.slots[slot] - 1;
    if (same(store.pages[held].at, at)) return held;
  }
  if (store.count == kGuidePages) return kGuidePages;
  Page& page = store.pages[store.count];
  page.reached = 0;
  page.closed = 0;
  page.at = at;
  page.heads = false;
  store.slots[slot] = static_cast<std::uint16_t>(store.count + 1);
  return store.count++;
}

}  // namespace tern

#endif
