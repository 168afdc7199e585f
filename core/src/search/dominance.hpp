// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Dominance: for every page of 4 x 4 x 4 voxels that the search has reached, one voxel and its cost. Another voxel of
// the page is dominated if the path straight from the recorded voxel is cheaper. Sweeps drop dominated voxels, so they
// cover no space twice.
#ifndef TERN_SEARCH_DOMINANCE_HPP
#define TERN_SEARCH_DOMINANCE_HPP

#include <cstdint>

#include "base/capacity.hpp"
#include "base/direction.hpp"
#include "grid/bit_rows.hpp"
#include "search/node_store.hpp"
#include "tern/config.hpp"
#include "tern/grid.hpp"

namespace tern {

/// Pages of the largest map. A map whose dimensions are no multiples of 4 may have more; its last pages have no
/// record.
constexpr std::int32_t kDominancePages = static_cast<std::int32_t>((kMaxCells + 63) / 64);

/// Plain data; needs no initialisation before dominance_reset, which clears one bit a page.
struct DominanceMap {
  std::int32_t width;                             ///< pages along x
  std::int32_t slice;                             ///< pages along x and y
  std::uint64_t known[kDominancePages / 64 + 1];  ///< one bit for each page: it has a record
  /// For each page, the recorded voxel's cost, rounded up to a multiple of 64, plus its place in the page, x + 4 y +
  /// 16 z.
  std::uint64_t records[kDominancePages];
};

inline void dominance_reset(DominanceMap& map, const Grid& grid) noexcept {
  const Voxel& dims = grid.spec().dims;
  map.width = (dims.x + 3) / 4;
  map.slice = map.width * ((dims.y + 3) / 4);
  const std::int64_t pages = std::int64_t{map.slice} * ((dims.z + 3) / 4);
  const std::int64_t used = pages < kDominancePages ? pages : kDominancePages;
  for (std::int64_t k = 0; k <= used / 64; ++k) map.known[k] = 0;
}

/// True if all voxels of the box between two voxels of one page are free. A page's rows lie within one word.
inline bool page_box_free(const Grid& grid, const Voxel& a, const Voxel& b) noexcept {
  const std::int32_t first_x = a.x < b.x ? a.x : b.x;
  const std::int32_t last_x = a.x < b.x ? b.x : a.x;
  const std::int32_t first_y = a.y < b.y ? a.y : b.y;
  const std::int32_t last_y = a.y < b.y ? b.y : a.y;
  const std::int32_t first_z = a.z < b.z ? a.z : b.z;
  const std::int32_t last_z = a.z < b.z ? b.z : a.z;
  const std::uint64_t mask = ((std::uint64_t{2} << (last_x - first_x)) - 1) << (first_x & 63);
  const BitRows rows = GridAccess::blocked(grid);
  std::uint64_t blocked = 0;
  for (std::int32_t z = first_z; z <= last_z; ++z) {
    for (std::int32_t y = first_y; y <= last_y; ++y) blocked |= rows.row(y, z)[first_x >> 6];
  }
  return (blocked & mask) == 0;
}

/// True if a path to `voxel` cheaper than `g` is known: from the page's recorded voxel, with the box between the two
/// free. Otherwise records the voxel, just reached at cost `g`, if it costs no more than the recorded one.
inline bool dominated_else_record(DominanceMap& map, const Grid& grid, const Voxel& voxel, Cost g) noexcept {
  constexpr Cost kPlaceMask = 63;
  const std::int32_t page = (voxel.x >> 2) + map.width * (voxel.y >> 2) + map.slice * (voxel.z >> 2);
  if (is_full(page >= kDominancePages)) return false;
  const std::uint64_t bit = std::uint64_t{1} << (page & 63);
  const auto place = static_cast<Cost>(place_in_page(voxel));
  std::uint64_t& record = map.records[page];
  const Cost cost = record & ~kPlaceMask;
  if ((map.known[page >> 6] & bit) == 0 || cost >= g) {
    map.known[page >> 6] |= bit;
    record = ((g + kPlaceMask) & ~kPlaceMask) | place;
    return false;
  }
  // A quick answer for most voxels: a path from another voxel takes at least one more step.
  if (cost + kStraightCost >= g && (record & kPlaceMask) != place) return false;
  const Voxel from = voxel_in_page(page_coordinates(voxel), static_cast<int>(record & kPlaceMask));
  return cost + octile(from, voxel) < g && page_box_free(grid, from, voxel);
}

}  // namespace tern

#endif
