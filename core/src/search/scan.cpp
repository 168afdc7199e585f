// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "search/scan.hpp"

#include "search/neighbourhood.hpp"
#include "search/prune.hpp"

namespace tern {

namespace {

/// If more than one region in this many has changed, it is cheaper to forget all stops. Forgetting those of one region
/// costs about as much as 64 regions' share of forgetting all.
constexpr std::int32_t kFewRegions = 64;

bool same_map(const ScanMap& map, const Grid& grid) {
  return map.kept && GridView::contents(grid) != nullptr && same(map.dims, grid.spec().dims);
}

/// Number of regions that have changed.
std::int32_t count_changed(const ScanMap& map, const Grid& grid, std::int32_t count) {
  const std::uint64_t* contents = GridView::contents(grid);
  std::int32_t changed = 0;
  for (std::int32_t k = 0; k < count; ++k) changed += map.contents[k] != contents[k] ? 1 : 0;
  return changed;
}

void forget_changed(ScanMap& map, const Grid& grid, const Regions& regions) {
  for (std::int32_t z = 0; z < regions.planes; ++z) {
    for (std::int32_t block = 0; block < regions.blocks; ++block) {
      for (std::int32_t word = 0; word < regions.words; ++word) {
        const std::int32_t k = regions.at(z, block, word);
        if (map.contents[k] == GridView::contents(grid)[k]) continue;
        map.contents[k] = GridView::contents(grid)[k];
        for (int a = 0; a < 3; ++a) jump_stops_forget(map.along[a], grid, a, z, block, word);
      }
    }
  }
}

}  // namespace

void scan_begin(ScanMap& map, const Grid& grid) noexcept {
  const Regions regions(grid.spec().dims);
  const std::int32_t count = regions.count();
  if (same_map(map, grid)) {
    const std::int32_t changed = count_changed(map, grid, count);
    if (changed == 0) return;
    if (changed <= count / kFewRegions) return forget_changed(map, grid, regions);
  }
  for (int a = 0; a < 3; ++a) jump_stops_reset(map.along[a], grid, a);
  map.kept = GridView::contents(grid) != nullptr && count <= kStopRegions;
  if (!map.kept) return;
  map.dims = grid.spec().dims;
  for (std::int32_t k = 0; k < count; ++k) map.contents[k] = GridView::contents(grid)[k];
}

namespace scan {

std::int32_t stepwise(const Grid& grid, const Voxel& goal, const Voxel& from, int move) noexcept {
  const Voxel step = offset(move);
  const int along = step.x != 0 ? 0 : (step.y != 0 ? 1 : 2);
  Voxel at = from + step;
  // At most kMaxDimension steps: nothing beyond the grid's face is free.
  while (grid.free(at)) {
    const CellMask free = free_cells(grid, at);
    if (same(at, goal) || forced_moves(move, free, legal_moves(free)) != 0) return axis(at, along);
    at = at + step;
  }
  return kNowhere;
}

}  // namespace scan
}  // namespace tern
