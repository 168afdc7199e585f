// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The voxels at which straight jumps stop: one bit for each voxel, axis and sense. A word holds 64 voxels along the
// axis, so that a jump is a load and a count of zeros. Words are made when a jump first reads them.
#ifndef TERN_SEARCH_JUMP_STOPS_HPP
#define TERN_SEARCH_JUMP_STOPS_HPP

#include <cstdint>

#include "tern/config.hpp"
#include "tern/grid.hpp"

namespace tern {

/// Capacity for the stops along one axis, in words. If a map does not fit because it is thin along the axis, jumps walk
/// voxel by voxel along that axis.
constexpr std::int32_t kJumpStopWords = static_cast<std::int32_t>((kMaxCells + 63) / 64);

/// The stops of jumps towards greater coordinates (`up`) and towards lesser ones (`down`). A stop is a voxel that is
/// blocked or past the grid's end, or a free voxel at which an arrival from the voxel before forces a move (prune.hpp).
struct JumpStopWord {
  std::uint64_t up;
  std::uint64_t down;
};

/// The stops along one axis. Lines along x have the numbers y + dims.y z, and are made word by word. Lines along y have
/// the numbers x + dims.x z; lines along z have the numbers x + dims.x y. Both are made in tiles: one word of each of
/// 64 lines side by side along x.
struct JumpStopLayer {
  std::int32_t words;                            ///< words of a line; 0 if the layer does not fit and is not used
  std::int32_t width;                            ///< lines side by side: dims.y for lines along x, otherwise dims.x
  std::int32_t columns;                          ///< tiles side by side along x; not used for lines along x
  std::uint64_t ready[kJumpStopWords / 64 + 1];  ///< one bit for each word along x, or for each tile along y or z
  std::uint8_t walked[kJumpStopWords];           ///< steps that jumps walked through a tile before it was made
  JumpStopWord bits[kJumpStopWords];
};

/// A tile is made once jumps have walked this many steps through it, voxel by voxel. Making it costs as much as about
/// 140 steps, so a tile that is jumped through only once or twice is never made.
constexpr std::uint8_t kWalkFirst = 64;

/// Prepares the layer of an axis, with nothing made yet: clears one bit for each word or tile, and the steps walked.
void jump_stops_reset(JumpStopLayer& layer, const Grid& grid, int axis) noexcept;

/// Makes word `word` of the line along x at (y, z), from three words of each of nine rows.
void jump_stops_fill_row(JumpStopLayer& layer, const Grid& grid, std::int32_t y, std::int32_t z,
                         std::int32_t word) noexcept;

/// Makes word `word` of the lines along `axis` (1 or 2) at x = 64 column .. 64 column + 63 and `third` on the third
/// axis: 64 steps from the words of three rows each, then two transpositions.
void jump_stops_fill_tile(JumpStopLayer& layer, const Grid& grid, int axis, std::int32_t column, std::int32_t third,
                          std::int32_t word) noexcept;

inline bool jump_stops_ready(const JumpStopLayer& layer, std::int32_t index) noexcept {
  return (layer.ready[index >> 6] >> (index & 63) & 1u) != 0;
}

/// Index of word `word` of the line along kAxis through a voxel, and index of the tile that holds the word.
template <int kAxis>
std::int32_t jump_stops_index(const JumpStopLayer& layer, const Voxel& v, std::int32_t word) noexcept {
  const std::int32_t line = (kAxis == 0 ? v.y : v.x) + layer.width * (kAxis == 2 ? v.y : v.z);
  return line * layer.words + word;
}
template <int kAxis>
std::int32_t jump_stops_tile(const JumpStopLayer& layer, const Voxel& v, std::int32_t word) noexcept {
  return ((kAxis == 2 ? v.y : v.z) * layer.columns + (v.x >> 6)) * layer.words + word;
}

}  // namespace tern

#endif
