// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BASE_CELLS_AFTER_HPP
#define TERN_BASE_CELLS_AFTER_HPP

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

/// A set of cells around a place, numbered as they lie around the end of a move from there. Those further away are left
/// out; all for kHere.
///
/// A search need not repeat the moves of the place before: what leads there directly is shorter than the way round.
constexpr CellMask cells_after(CellMask cells, int move) {
  // By 13 up and by the move's number down, so that no branch depends on the direction.
  return static_cast<CellMask>(std::uint64_t{cells} << kHere >> move) & kCommonCells.after[move];
}

}  // namespace tern

#endif
