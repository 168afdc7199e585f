// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_GUIDE_CELLS_AFTER_HPP
#define TERN_GUIDE_CELLS_AFTER_HPP

#include "base/direction.hpp"

namespace tern {

/// For each move, the cells around its end that also lie around its beginning. None for kHere.
struct CommonCells {
  CellMask after[kDirections];
};
constexpr CommonCells make_common_cells() {
  CommonCells common{};
  for (int move = 0; move < kDirections; ++move) {
    for (int cell = 0; cell < kDirections; ++cell) {
      const Voxel from = offset(move) + offset(cell);
      const bool around = magnitude(from.x) <= 1 && magnitude(from.y) <= 1 && magnitude(from.z) <= 1;
      if (around && move != kHere) common.after[move] |= cell_bit(cell);
    }
  }
  return common;
}
inline constexpr CommonCells kCommonCells = make_common_cells();

/// Renumbers a set of cells around a voxel as cells around the end of a move from that voxel. Cells that are not around
/// the end are left out; for kHere, all are.
///
/// A search need not move to a cell that the voxel before could move to: the direct move is shorter than the way round.
constexpr CellMask cells_after(CellMask cells, int move) {
  // Shifts up by kHere and down by the move's number, so that no branch depends on the direction.
  return static_cast<CellMask>(std::uint64_t{cells} << kHere >> move) & kCommonCells.after[move];
}

}  // namespace tern

#endif
