// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A tile: a part of the blocked layer that is being made, with consecutive rows and consecutive words.
#ifndef TERN_INFLATION_INFLATION_TILE_HPP
#define TERN_INFLATION_INFLATION_TILE_HPP

#include <cstdint>

#include "grid/bit_rows.hpp"
#include "grid/stencil.hpp"
#include "tern/grid.hpp"

namespace tern {

/// The most words of a tile: few enough for the stack and the first-level cache, and at least a row of the widest grid.
constexpr std::int32_t kTileWords = kMaxRowWords > 128 ? kMaxRowWords : 128;

/// Rows y .. y + rows - 1 of plane z; of each row, `width` words from word `first` on. rows * width <= kTileWords. A
/// tile with a shift is one word wide: it has the 64 voxels of each row from voxel 64 first + shift on, and `first` may
/// be -1.
struct InflationTile {
  std::int32_t y;
  std::int32_t z;
  std::int32_t rows;
  std::int32_t first;
  std::int32_t width;
  std::int32_t shift;
  bool apart;                              ///< no row spreads into bits of the next row that matter
  int made;                                ///< the buffer that holds the tile; spreading writes to the other one
  std::uint64_t words[2][kTileWords + 2];  ///< row by row from index 1 on; one word before and after them may be read

  const std::uint64_t* row(std::int32_t r) const noexcept { return words[made] + 1 + r * width; }
};

/// Fills the tile: sets each voxel that an obstacle blocks, as the stencil says. Ignores obstacles outside the tile's
/// words along x, so the outermost gap_x + 1 voxels are correct only at an end of the grid's own row.
void make_inflation_tile(const Grid& grid, const Stencil& stencil, InflationTile& tile) noexcept;

}  // namespace tern

#endif
