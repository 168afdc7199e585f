// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds forced neighbours of straight moves, 64 voxels a word. An arrival at n from p = n - u, with u straight, forces
// a move if there is a side s, straight or diagonal, for which p + s is blocked and one of
// these holds:
// - s is straight, and n + s is free (the move s);
// - s = a + b is diagonal, and n + u, n + a, n + b, n + s and the same three beside n + u are free (the move s + u).
// All other rules of prune.hpp for straight arrivals follow from these.
#include "search/jump_stops.hpp"

#include "base/capacity.hpp"
#include "grid/lattice.hpp"

namespace tern {
namespace {

constexpr std::int32_t kSide = 64;
constexpr std::uint64_t kAllBlocked = ~std::uint64_t{0};

void mark_ready(JumpStopLayer& layer, std::int32_t index) {
  layer.ready[index >> 6] |= std::uint64_t{1} << (index & 63);
}

/// A word of a blocked row with the words before and after it. Everything past the grid's faces counts as blocked.
struct RowWords {
  std::uint64_t before;
  std::uint64_t word;
  std::uint64_t after;

  /// The bit of voxel x - 1 (lesser) or of voxel x + 1 (greater), in the place of voxel x.
  std::uint64_t lesser() const { return word << 1 | before >> 63; }
  std::uint64_t greater() const { return word >> 1 | after << 63; }
};

constexpr RowWords kNoRow{kAllBlocked, kAllBlocked, kAllBlocked};

/// Reads word `column` of blocked rows. Finds out only once whether a row has words before and after it.
struct RowReader {
  BitRows rows;
  std::int32_t word;
  Voxel dims;
  std::int32_t to_before;     ///< 1; 0 if the row has no word before
  std::int32_t to_after;      ///< 1; 0 if the row has no word after
  std::uint64_t past_before;  ///< what counts as blocked in the word before
  std::uint64_t past_after;

  RowReader(const Grid& grid, std::int32_t column)
      : rows(GridAccess::blocked(grid)),
        word(column),
        dims(grid.spec().dims),
        to_before(column > 0 ? 1 : 0),
        to_after(column + 1 < rows.row_words ? 1 : 0),
        past_before(to_before != 0 ? 0 : kAllBlocked),
        past_after(to_after != 0 ? 0 : kAllBlocked) {}

  RowWords at(std::int32_t y, std::int32_t z) const {
    if (y < 0 || z < 0 || y >= dims.y || z >= dims.z) return kNoRow;
    const std::uint64_t* own = rows.row(y, z) + word;
    return {own[-to_before] | past_before, own[0], own[to_after] | past_after};
  }
};

RowWords either(const RowWords& a, const RowWords& b) {
  return {a.before | b.before, a.word | b.word, a.after | b.after};
}

/// Adds the stops that one straight side of a line along x makes.
void add_straight_side(JumpStopWord& stop, const RowWords& side) {
  stop.up |= side.lesser() & ~side.word;
  stop.down |= side.greater() & ~side.word;
}

/// Adds the stops that one diagonal side of a line along x makes. A voxel of `square` is blocked if the diagonal side,
/// one of its two straight parts or the line is.
void add_diagonal_side(JumpStopWord& stop, const RowWords& side, const RowWords& square) {
  stop.up |= side.lesser() & ~(square.word | square.greater());
  stop.down |= side.greater() & ~(square.word | square.lesser());
}

/// The blocked voxels of 64 lines along y or z, and those beside them, at one step along the lines.
struct Slice {
  std::uint64_t own;
  std::uint64_t side[4];      ///< straight sides: lesser and greater x, lesser and greater third axis
  std::uint64_t diagonal[4];  ///< lesser x and lesser third, greater x and lesser third, then both with greater third
  std::uint64_t square[4];    ///< blocked if the diagonal side, one of its straight parts or the line is
};

/// Reads step `along` of the lines along kAxis at `third`.
template <int kAxis>
Slice slice_at(const RowReader& rows, std::int32_t along, std::int32_t third) {
  const auto row = [&](std::int32_t t) { return kAxis == 1 ? rows.at(along, t) : rows.at(t, along); };
  const RowWords own = row(third);
  const RowWords low = row(third - 1);
  const RowWords high = row(third + 1);
  Slice s{own.word,
          {own.lesser(), own.greater(), low.word, high.word},
          {low.lesser(), low.greater(), high.lesser(), high.greater()},
          {}};
  for (int k = 0; k < 4; ++k) s.square[k] = s.own | s.side[k & 1] | s.side[2 + (k >> 1)] | s.diagonal[k];
  return s;
}

/// Stops at step `at` of jumps that come from step `from` and go on to step `to`.
std::uint64_t stops_between(const Slice& from, const Slice& at, const Slice& to) {
  std::uint64_t stop = at.own;
  for (int k = 0; k < 4; ++k) {
    stop |= from.side[k] & ~at.side[k];
    stop |= from.diagonal[k] & ~(at.square[k] | to.square[k]);
  }
  return stop;
}

/// Computes the stops of a tile before it is transposed: for each step, one word for 64 lines.
template <int kAxis>
void compute_tile(const Grid& grid, std::int32_t column, std::int32_t third, std::int32_t word,
                  std::uint64_t (&up)[kSide], std::uint64_t (&down)[kSide]) {
  const RowReader rows(grid, column);
  const std::int32_t first = word * kSide;
  const std::int32_t left = axis(grid.spec().dims, kAxis) - first;
  const std::int32_t steps = left < kSide ? left : kSide;
  Slice slices[3];
  Slice* before = slices;
  Slice* at = slices + 1;
  Slice* after = slices + 2;
  for (std::int32_t k = -2; k < steps; ++k) {  // the first two turns only read what the third needs
    *after = slice_at<kAxis>(rows, first + k + 1, third);
    if (k >= 0) {
      up[k] = stops_between(*before, *at, *after);
      down[k] = stops_between(*after, *at, *before);
    }
    Slice* const oldest = before;
    before = at;
    at = after;
    after = oldest;
  }
  for (std::int32_t k = steps; k < kSide; ++k) up[k] = down[k] = kAllBlocked;
}

/// Transposes a 64 x 64 bit matrix in place: swaps ever smaller quarters off the diagonal.
void transpose(std::uint64_t (&tile)[kSide]) {
  std::uint64_t mask = 0x00000000FFFFFFFFu;
  for (std::int32_t half = kSide / 2; half > 0; half /= 2, mask ^= mask << half) {
    for (std::int32_t first = 0; first < kSide; first += 2 * half) {
      for (std::int32_t k = first; k < first + half; ++k) {
        const std::uint64_t swap = (tile[k] >> half ^ tile[k + half]) & mask;
        tile[k] ^= swap << half;
        tile[k + half] ^= swap;
      }
    }
  }
}

}  // namespace

void jump_stops_reset(JumpStopLayer& layer, const Grid& grid, int axis_along) noexcept {
  const Voxel& dims = grid.spec().dims;
  const std::int32_t thirds = axis_along == 2 ? dims.y : dims.z;
  layer.words = (axis(dims, axis_along) + kSide - 1) / kSide;
  layer.width = axis_along == 0 ? dims.y : dims.x;
  layer.columns = (dims.x + kSide - 1) / kSide;
  if (is_full(std::int64_t{layer.words} * layer.width * thirds > kJumpStopWords)) {
    layer.words = 0;
    return;
  }
  const std::int32_t bits = layer.words * thirds * (axis_along == 0 ? layer.width : layer.columns);
  for (std::int32_t k = 0; k <= bits / 64; ++k) layer.ready[k] = 0;
  if (axis_along == 0) return;
  for (std::int32_t k = 0; k < bits; ++k) layer.walked[k] = 0;
}

void jump_stops_fill_row(JumpStopLayer& layer, const Grid& grid, std::int32_t y, std::int32_t z,
                         std::int32_t word) noexcept {
  const RowReader rows(grid, word);
  const auto row = [&](std::int32_t dy, std::int32_t dz) { return rows.at(y + dy, z + dz); };
  const RowWords own = row(0, 0);
  const RowWords side_y[] = {row(-1, 0), row(1, 0)};
  const RowWords side_z[] = {row(0, -1), row(0, 1)};
  JumpStopWord stop{own.word, own.word};
  for (int k = 0; k < 2; ++k) {
    add_straight_side(stop, side_y[k]);
    add_straight_side(stop, side_z[k]);
  }
  for (int k = 0; k < 4; ++k) {
    const RowWords diagonal = row((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1);
    const RowWords sides = either(either(own, side_y[k & 1]), side_z[k >> 1]);
    add_diagonal_side(stop, diagonal, either(diagonal, sides));
  }
  const std::int32_t index = (y + layer.width * z) * layer.words + word;
  layer.bits[index] = stop;
  mark_ready(layer, index);
}

void jump_stops_fill_tile(JumpStopLayer& layer, const Grid& grid, int axis_along, std::int32_t column,
                          std::int32_t third, std::int32_t word) noexcept {
  std::uint64_t up[kSide];
  std::uint64_t down[kSide];
  if (axis_along == 1) {
    compute_tile<1>(grid, column, third, word, up, down);
  } else {
    compute_tile<2>(grid, column, third, word, up, down);
  }
  transpose(up);
  transpose(down);
  const std::int32_t left = grid.spec().dims.x - column * kSide;
  const std::int32_t lines = left < kSide ? left : kSide;
  JumpStopWord* out = layer.bits + (third * layer.width + column * kSide) * layer.words + word;
  for (std::int32_t k = 0; k < lines; ++k) out[k * layer.words] = {up[k], down[k]};
  mark_ready(layer, (third * layer.columns + column) * layer.words + word);
}

}  // namespace tern
