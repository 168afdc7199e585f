// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_SEARCH_NEIGHBOURHOOD_HPP
#define TERN_SEARCH_NEIGHBOURHOOD_HPP

#include <cstdint>

#include "base/direction.hpp"
#include "grid/bit_rows.hpp"
#include "tern/grid.hpp"

namespace tern {

/// Three neighbouring bits of a row of the blocked layer, x - 1 in bit 0; blocked outside the row. `x` lies in the row.
inline CellMask blocked_triple(const std::uint64_t* row, std::int32_t words, std::int32_t x) noexcept {
  const std::int32_t word = x >> 6;
  const int bit = x & 63;
  if (bit != 0 && bit != 63) return static_cast<CellMask>(row[word] >> (bit - 1)) & 7u;
  if (bit == 0) {
    const CellMask below = word > 0 ? static_cast<CellMask>(row[word - 1] >> 63) : 1u;
    return below | (static_cast<CellMask>(row[word]) & 3u) << 1;
  }
  const CellMask above = word + 1 < words ? static_cast<CellMask>(row[word + 1]) & 1u : 1u;
  return static_cast<CellMask>(row[word] >> 62) | above << 2;
}

/// Blocked voxels at x - 1, x and x + 1 of a row, bits 0 to 2; all three if the row lies outside the grid.
inline CellMask triple_at(const Grid& grid, std::int32_t x, std::int32_t y, std::int32_t z) noexcept {
  const Voxel& dims = grid.spec().dims;
  if (y < 0 || z < 0 || y >= dims.y || z >= dims.z) return 7;
  return blocked_triple(grid.blocked_row(y, z), grid.row_words(), x);
}

/// The free cells of the 3x3x3 neighbourhood of a voxel inside the grid; nothing is free outside the grid.
inline CellMask free_cells_at_face(const Grid& grid, const Voxel& v) noexcept {
  CellMask blocked = 0;
  int shift = 0;
  for (std::int32_t z = v.z - 1; z <= v.z + 1; ++z) {
    for (std::int32_t y = v.y - 1; y <= v.y + 1; ++y, shift += 3) blocked |= triple_at(grid, v.x, y, z) << shift;
  }
  return blocked ^ kAllCells;
}

/// The free cells of the 3x3x3 neighbourhood of a voxel inside the grid. Fast for most voxels: those that are not at
/// the grid's faces and have their neighbours along x in the same word.
inline CellMask free_cells(const Grid& grid, const Voxel& v) noexcept {
  const Voxel& dims = grid.spec().dims;
  const int bit = v.x & 63;
  if (bit == 0 || bit == 63 || v.y == 0 || v.z == 0 || v.y + 1 == dims.y || v.z + 1 == dims.z)
    return free_cells_at_face(grid, v);
  const BitRows rows = GridAccess::blocked(grid);
  const std::uint64_t* first = rows.row(v.y - 1, v.z - 1) + (v.x >> 6);
  const std::int64_t row = rows.index(1, 0);
  const std::int64_t slice = rows.index(0, 1);
  CellMask blocked = 0;
  for (int z = 0; z < 3; ++z) {
    for (int y = 0; y < 3; ++y) {
      blocked |= (static_cast<CellMask>(first[y * row + z * slice] >> (bit - 1)) & 7u) << (3 * y + 9 * z);
    }
  }
  return blocked ^ kAllCells;
}

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
/// A search uses this to leave out the cells that the voxel before could move to: the direct move is shorter.
constexpr CellMask cells_after(CellMask cells, int move) {
  // Shifts up by kHere and down by the move's number, so that no branch depends on the direction.
  return static_cast<CellMask>(std::uint64_t{cells} << kHere >> move) & kCommonCells.after[move];
}

}  // namespace tern

#endif
