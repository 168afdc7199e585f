// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/scan.hpp"

#include "path/neighbourhood.hpp"
#include "path/prune.hpp"

namespace tern {

void scan_reset(ScanMap& map, const Grid& grid) noexcept {
  for (int a = 0; a < 3; ++a) stops_reset(map.along[a], grid, a);
}

namespace scan {

std::int32_t stepwise(const Grid& grid, const Voxel& goal, const Voxel& from, int move) noexcept {
  const Voxel step = offset(move);
  const int along = step.x != 0 ? 0 : (step.y != 0 ? 1 : 2);
  Voxel at = from + step;
  // At most kMaxDimension steps: nothing beyond the grid's face is free.
  while (grid.free(at)) {
    if (same(at, goal) || forced_moves(move, free_cells(grid, at)) != 0) return axis(at, along);
    at = at + step;
  }
  return kNowhere;
}

}  // namespace scan
}  // namespace tern
