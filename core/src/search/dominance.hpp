// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Dominance: for every block of 4 x 4 x 4 voxels that the search has reached, one voxel and its cost. Another voxel of
// the block is dominated if the path straight from the recorded voxel is cheaper. Sweeps drop dominated voxels, so they
// cover no space twice.
#ifndef TERN_SEARCH_DOMINANCE_HPP
#define TERN_SEARCH_DOMINANCE_HPP

#include <cstdint>

#include "base/capacity.hpp"
#include "base/direction.hpp"
#include "tern/config.hpp"
#include "tern/grid.hpp"

namespace tern {

/// Blocks of the largest map. A map whose dimensions are no multiples of 4 may have more; its last blocks have no
/// record.
constexpr std::int32_t kDominanceBlocks = static_cast<std::int32_t>((kMaxCells + 63) / 64);

/// Plain data; needs no initialisation before dominance_reset, which clears one bit a block.
struct DominanceMap {
  std::int32_t width;  ///< blocks along x; `slice`: blocks of a layer in x and y
  std::int32_t slice;
  std::uint64_t known[kDominanceBlocks / 64 + 1];  ///< one bit for each block: it has a record
  /// For each block, the recorded voxel's cost, rounded up to a multiple of 64, plus its place in the block, x + 4 y +
  /// 16 z.
  std::uint64_t records[kDominanceBlocks];
};

void dominance_reset(DominanceMap& map, const Grid& grid) noexcept;

/// True if all voxels of the box between two voxels of one block are free.
bool block_box_free(const Grid& grid, const Voxel& a, const Voxel& b) noexcept;

/// True if a cheaper path than `g` to `voxel` is known: from the block's recorded voxel, with the box between the two
/// free. Otherwise records the voxel, just reached at cost `g`, if it costs no more than the recorded one.
inline bool dominated_else_record(DominanceMap& map, const Grid& grid, const Voxel& voxel, Cost g) noexcept {
  constexpr Cost kPlaceMask = 63;
  const std::int32_t block = (voxel.x >> 2) + map.width * (voxel.y >> 2) + map.slice * (voxel.z >> 2);
  if (is_full(block >= kDominanceBlocks)) return false;
  const std::uint64_t bit = std::uint64_t{1} << (block & 63);
  const auto place = static_cast<Cost>((voxel.x & 3) | (voxel.y & 3) << 2 | (voxel.z & 3) << 4);
  std::uint64_t& record = map.records[block];
  const Cost cost = record & ~kPlaceMask;
  if ((map.known[block >> 6] & bit) == 0 || cost >= g) {
    map.known[block >> 6] |= bit;
    record = ((g + kPlaceMask) & ~kPlaceMask) | place;
    return false;
  }
  // Most voxels are not dominated: another voxel is at least one step away from the recorded one.
  if (cost + kStraightCost >= g && (record & kPlaceMask) != place) return false;
  const auto at = static_cast<std::int32_t>(record & kPlaceMask);
  const Voxel from{(voxel.x & ~3) + (at & 3), (voxel.y & ~3) + (at >> 2 & 3), (voxel.z & ~3) + (at >> 4)};
  return cost + octile(from, voxel) < g && block_box_free(grid, from, voxel);
}

}  // namespace tern

#endif
