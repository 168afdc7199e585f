// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fills the free voxels that are connected to given ones, a row of the blocked layer at a time. The moves of a search
// cut no corner, so the flood reaches the voxels that a search can reach: those that are connected through faces.
#ifndef TERN_PATH_FLOOD_HPP
#define TERN_PATH_FLOOD_HPP

#include <cstddef>
#include <cstdint>

#include "tern/grid.hpp"
#include "world/solids.hpp"

namespace tern {

/// The most rows that a flood takes off its queue. Each time, it fills at least one run of free voxels.
constexpr std::uint32_t kFloodBound = static_cast<std::uint32_t>(kMaxCells);

/// The words that one call of flood_clear clears, and the most calls of it.
constexpr std::size_t kClearedWords = 1024;
constexpr std::uint32_t kClearBound = static_cast<std::uint32_t>(kMaxWorldWords / kClearedWords) + 1u;

/// Plain data; needs no initialisation before flood_begin. Rows have numbers y + dims.y z.
struct Flood {
  std::uint64_t dry[kMaxWorldWords];  ///< rows like those of the grid; a bit is 0 if its voxel has been reached
  std::uint64_t waiting[kMaxWorldWords / 64 + 1];  ///< one bit for each row: it is in the queue
  std::uint32_t queue[kMaxWorldWords];  ///< rows in which new voxels have been reached, first come, first served
  std::size_t words;                    ///< words of a layer of the grid
  std::size_t cleared;                  ///< how many of these words have been cleared
  std::uint32_t rows;                   ///< rows of the grid
  std::uint32_t first;                  ///< index of the first entry of the queue, which wraps around
  std::uint32_t count;
};

/// The grid must be inflated and must not change until the flood ends. False if its layers have more than
/// kMaxWorldWords words.
bool flood_begin(Flood& flood, const Grid& grid) noexcept;

/// Clears a part of the flood's layers. True once all is clear: nothing is reached.
bool flood_clear(Flood& flood) noexcept;

/// Begins to flood from a free voxel, which counts as reached.
void flood_from(Flood& flood, const Grid& grid, const Voxel& voxel) noexcept;

/// Takes a row off the queue, which must not be empty, fills its runs of free voxels, and goes on to the rows beside
/// it.
void flood_row(Flood& flood, const Grid& grid) noexcept;

/// The grid in which only the voxels that the flood has reached are free. Its blocked layer is the flood's memory.
Grid flooded(Flood& flood, const Grid& grid) noexcept;

}  // namespace tern

#endif
