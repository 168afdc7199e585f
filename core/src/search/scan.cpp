// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "search/scan.hpp"

#include "search/neighbourhood.hpp"
#include "search/prune.hpp"

namespace tern {

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
