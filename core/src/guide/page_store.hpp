// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_GUIDE_PAGE_STORE_HPP
#define TERN_GUIDE_PAGE_STORE_HPP

#include <cstdint>

#include "guide/block_map.hpp"
#include "search/node_store.hpp"

namespace tern {

/// Pages of one search of voxels. 8192 expansions (guided_search.hpp) take some hundreds of them in most maps.
constexpr std::int32_t kGuidePages = kMaxNodes / 8 < 4096 ? kMaxNodes / 8 : 4096;
constexpr std::uint32_t kPageSlots = power_of_two(2u * static_cast<std::uint32_t>(kGuidePages));

/// What the search knows of 4 x 4 x 4 voxels, and where it heads from there.
struct Page {
  std::uint64_t reached;     ///< one bit a voxel, x + 4 y + 16 z: a path is known
  std::uint64_t closed;      ///< it was expanded
  Voxel at;                  ///< the page's coordinates: voxels / 4
  Voxel carrot;              ///< voxel to head for; valid where `heads`
  GuideCost rest;            ///< estimate from there to the goal; from anywhere in the page where it does not head yet
  bool heads;                ///< the carrot is known: the guide has closed the page's block
  std::uint8_t arrival[64];  ///< the move by which the best path reaches a voxel
  GuideCost cost[64];        ///< of that path
};

/// The pages of one search, found by their coordinates: an open-addressing table over a pool.
struct PageStore {
  std::int32_t count;
  std::uint16_t slots[kPageSlots];  ///< 0 where free, otherwise 1 + the page
  Page pages[kGuidePages];
};
static_assert(kGuidePages < 65535, "a slot is a page's number and one");

/// Empties the store; clears the slots, 16 KB at most.
void page_store_reset(PageStore& store) noexcept;

/// The page of a voxel, made with no voxel reached where there is none yet; kGuidePages where the store is
/// full.
std::int32_t page_find_or_add(PageStore& store, const Voxel& voxel) noexcept;

/// The voxel at a place of a page, which is the same as that in a block of four voxels.
constexpr Voxel page_voxel(const Page& page, int place) {
  return {page.at.x * 4 + (place & 3), page.at.y * 4 + (place >> 2 & 3), page.at.z * 4 + (place >> 4)};
}

}  // namespace tern

#endif
