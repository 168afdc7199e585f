// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Copies of the blocked layer with 64 voxels a word along y or z, so that scans along those axes are as fast as along
// x.
#ifndef TERN_PATH_TURNED_HPP
#define TERN_PATH_TURNED_HPP

#include <cstdint>

#include "tern/config.hpp"
#include "tern/grid.hpp"

namespace tern {

/// Words of one turned copy. A map whose copy does not fit (it is thin along the axis) is scanned voxel by voxel.
constexpr std::int32_t kTurnedWords = static_cast<std::int32_t>((kMaxCells + 63) / 64);

/// The blocked layer turned so that rows run along one axis: one row for each x and each index along the third axis.
/// Tiles of up to 64 x 64 voxels are turned when a scan first reads them, so that a search pays for what it visits.
struct TurnedLayer {
  std::int32_t axis;                           ///< 1 or 2: rows run along y or z
  std::int32_t words;                          ///< of a row; 0 where the copy does not fit and is not used
  std::int32_t width;                          ///< rows side by side along x
  std::int32_t blocks;                         ///< tiles side by side along x
  std::uint64_t ready[kTurnedWords / 64 + 1];  ///< one bit a tile
  std::uint64_t bits[kTurnedWords];
};

/// Prepares a copy of the grid's blocked layer with no tile turned yet: clears one bit a tile.
void turned_reset(TurnedLayer& layer, const Grid& grid, int axis) noexcept;

/// The row for an x and an index along the third axis; only words whose tile is ready may be read.
inline const std::uint64_t* turned_row(const TurnedLayer& layer, std::int32_t x, std::int32_t third) noexcept {
  return layer.bits + (static_cast<std::int64_t>(third) * layer.width + x) * layer.words;
}

/// Turns the tile that holds word `word` of the row of x and third.
void turned_fill(TurnedLayer& layer, const Grid& grid, std::int32_t block, std::int32_t third,
                 std::int32_t word) noexcept;

/// Makes sure that the tile of 64 rows around 64 * block is ready in that word. Bits past the grid's end are 1.
inline void turned_prepare(TurnedLayer& layer, const Grid& grid, std::int32_t block, std::int32_t third,
                           std::int32_t word) noexcept {
  const std::int32_t tile = (third * layer.blocks + block) * layer.words + word;
  if ((layer.ready[tile >> 6] >> (tile & 63) & 1u) == 0) turned_fill(layer, grid, block, third, word);
}

}  // namespace tern

#endif
