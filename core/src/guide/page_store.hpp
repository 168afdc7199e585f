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
constexpr std::uint32_t kPageSlots = power_of_two(2u * static_cast<std::uint32_t>(kGuidePages));

/// What the search knows about 4 x 4 x 4 voxels, and the carrot for all of them.
struct Page {
  std::uint64_t reached;     ///< one bit for each voxel, x + 4 y + 16 z: a path is known
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
  std::uint16_t slots[kPageSlots];  ///< 0 if free, otherwise 1 + the page
  Page pages[kGuidePages];
};
static_assert(kGuidePages < 65535, "a slot is a page's number and one");

/// Empties the store; clears the slots, 16 KB at most.
void page_store_reset(PageStore& store) noexcept;

/// The page of a voxel. Makes one, with no voxel reached, if there is none yet; kGuidePages if the store is full.
std::int32_t page_find_or_add(PageStore& store, const Voxel& voxel) noexcept;

/// The voxel at a place of a page. Places are numbered as in a block of four voxels.
constexpr Voxel page_voxel(const Page& page, int place) {
  return {page.at.x * 4 + (place & 3), page.at.y * 4 + (place >> 2 & 3), page.at.z * 4 + (place >> 4)};
}

}  // namespace tern

#endif
