// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A piece of the blocked layer in the making: a window of consecutive rows and consecutive words.
#ifndef TERN_INFLATION_INFLATION_TILE_HPP
#define TERN_INFLATION_INFLATION_TILE_HPP

#include <cstdint>

#include "grid/bit_rows.hpp"
#include "grid/stencil.hpp"
#include "tern/grid.hpp"

namespace tern {

/// Words of a tile: small enough for the stack and the first-level cache, and a row of the widest grid at least.
constexpr std::int32_t kTileWords = kMaxRowWords > 128 ? kMaxRowWords : 128;

/// Rows y .. y + rows - 1 of plane z, of each the `width` words from word `first` on: rows * width <= kTileWords. A
/// tile with a shift has 64 voxels of each row, from voxel 64 first + shift on, where `first` may be -1. Such a tile is
/// one word wide.
struct InflationTile {
  std::int32_t y;
  std::int32_t z;
  std::int32_t rows;
  std::int32_t first;
  std::int32_t width;
  std::int32_t shift;
  bool apart;  ///< what spreads past a row within the tile reaches no bit of the next row that counts
  int made;    ///< which of the buffers holds the tile; spreading goes from one to the other
  std::uint64_t words[2][kTileWords + 2];  ///< row after row from index 1 on; the words around them may be read

  const std::uint64_t* row(std::int32_t r) const noexcept { return words[made] + 1 + r * width; }
};

/// Fills the tile: each voxel that an obstacle blocks by the stencil. What lies beyond the window along x is not seen:
/// the outermost gap_x + 1 voxels are right only where the window ends with the grid's own row.
void make_inflation_tile(const Grid& grid, const Stencil& stencil, InflationTile& tile) noexcept;

}  // namespace tern

#endif
