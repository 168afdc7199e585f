// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Inflation, 64 voxels a word. Blocked rows are gathered from the obstacle rows around them, a tile of consecutive rows
// at a time: rows that are neighbours along y lie one after another in memory, so that each step of the gathering is
// one long OR. Any range of rows can be made alone.
#include "grid/lattice.hpp"
#include "grid/stencil.hpp"
#include "tern/grid.hpp"

namespace tern {
namespace {

constexpr std::int32_t kMaxRowWords = (kMaxDimension + 63) / 64;
/// Words of a tile of blocked rows, and of the obstacle rows gathered for it, which are some more: small enough for the
/// stack and the first-level cache, and a row of the widest grid at least.
constexpr std::int32_t kTileWords = kMaxRowWords > 128 ? kMaxRowWords : 128;
constexpr std::int32_t kColumnWords = kTileWords + 48;

/// Blocked rows y .. y + rows - 1 of plane z in the making.
struct Tile {
  std::int32_t y;
  std::int32_t z;
  std::int32_t rows;
  std::uint64_t words[kTileWords];
};

/// Obstacle rows y .. y + rows - 1, several planes ORed into one.
struct Column {
  std::int32_t y;
  std::int32_t rows;
  std::uint64_t words[kColumnWords];
};

/// A part of a round: rows inner < |dy| <= outer of the planes gap_z_begin <= gap_z < gap_z_end.
struct Ring {
  std::int32_t gap_z_begin;
  std::int32_t gap_z_end;
  std::int32_t inner;
  std::int32_t outer;
};

std::int32_t clamp_plane(std::int32_t z, std::int32_t count) {
  return z < 0 ? 0 : (z < count ? z : count - 1);
}

/// words |= a | b; the OR of all words is returned.
std::uint64_t add_planes(const std::uint64_t* a, const std::uint64_t* b, std::int32_t count, std::uint64_t* words) {
  std::uint64_t any = 0;
  for (std::int32_t k = 0; k < count; ++k) {
    const std::uint64_t word = words[k] | a[k] | b[k];
    words[k] = word;
    any |= word;
  }
  return any;
}

/// Empties the column's rows that lie past the grid and returns the others as words [begin, end) of it.
IndexRange rows_in_grid(const Grid& grid, Column& column) {
  const std::int32_t row_words = grid.row_words();
  const std::int32_t past = grid.spec().dims.y - column.y < column.rows ? grid.spec().dims.y - column.y : column.rows;
  const IndexRange rows{column.y < 0 ? -column.y : 0, past};
  const IndexRange words{rows.begin * row_words, rows.end * row_words};
  for (std::int32_t k = 0; k < words.begin && k < column.rows * row_words; ++k) column.words[k] = 0;
  for (std::int32_t k = words.end < 0 ? 0 : words.end; k < column.rows * row_words; ++k) column.words[k] = 0;
  return words;
}

/// Makes the column of the ring's planes around plane z; false where it has no obstacle. Planes past the grid are
/// replaced by its last one, which is nearer and so blocks as much anyway.
bool gather_column(const Grid& grid, const Ring& ring, std::int32_t z, Column& column) {
  const std::int32_t planes = grid.spec().dims.z;
  const IndexRange range = rows_in_grid(grid, column);
  if (range.begin >= range.end) return false;
  const std::int32_t first = column.y < 0 ? 0 : column.y;
  std::uint64_t* words = column.words + range.begin;
  const std::int32_t count = range.end - range.begin;
  const std::uint64_t* own = grid.obstacle_row(first, z);
  for (std::int32_t k = 0; k < count; ++k) words[k] = ring.gap_z_begin == 0 ? own[k] : 0;
  std::uint64_t any = 0;
  for (std::int32_t gap = ring.gap_z_begin; gap < ring.gap_z_end; ++gap) {
    const std::uint64_t* below = grid.obstacle_row(first, clamp_plane(z - gap - 1, planes));
    const std::uint64_t* above = grid.obstacle_row(first, clamp_plane(z + gap + 1, planes));
    any = add_planes(below, above, count, words);
  }
  return any != 0;
}

/// words |= the OR of kRows consecutive rows, of which `rows` begins the first.
template <int kRows>
void add_rows(const std::uint64_t* rows, std::int32_t row_words, std::int32_t count, std::uint64_t* words) {
  for (std::int32_t k = 0; k < count; ++k) {
    std::uint64_t word = words[k];
    for (int r = 0; r < kRows; ++r) word |= rows[k + r * row_words];
    words[k] = word;
  }
}

/// Adds to each row of the tile the column's rows that are begin <= dy < end further.
void add_span(const Column& column, std::int32_t begin, std::int32_t end, std::int32_t row_words, Tile& tile) {
  if (begin >= end) return;
  const std::uint64_t* rows = column.words + (tile.y + begin - column.y) * row_words;
  const std::int32_t count = tile.rows * row_words;
  std::int32_t left = end - begin;
  for (; left >= 5; left -= 5, rows += 5 * row_words) add_rows<5>(rows, row_words, count, tile.words);
  for (; left >= 2; left -= 2, rows += 2 * row_words) add_rows<2>(rows, row_words, count, tile.words);
  if (left == 1) add_rows<1>(rows, row_words, count, tile.words);
}

/// Adds a ring to the tile: for a span of dy at a time, as long as a column holds, the rows that the tile's rows reach.
void gather_ring(const Grid& grid, const Ring& ring, Tile& tile) {
  const std::int32_t row_words = grid.row_words();
  const std::int32_t longest = kColumnWords / row_words - tile.rows + 1;
  Column column;
  for (std::int32_t begin = -ring.outer; begin <= ring.outer; begin += longest) {
    const std::int32_t end = begin + longest <= ring.outer ? begin + longest : ring.outer + 1;
    if (begin >= -ring.inner && end <= ring.inner + 1) continue;
    column.y = tile.y + begin;
    column.rows = tile.rows + end - begin - 1;
    if (!gather_column(grid, ring, tile.z, column)) continue;
    if (ring.inner < 0) {
      add_span(column, begin, end, row_words, tile);
    } else {
      add_span(column, begin, end < -ring.inner ? end : -ring.inner, row_words, tile);
      const std::int32_t past = begin > ring.inner ? begin : ring.inner + 1;
      add_span(column, past, end, row_words, tile);
    }
  }
}

/// The next ring of a round from plane gap gap_z on: planes of equal reach go together. What reaches further along x
/// came in an earlier round.
Ring next_ring(const Stencil& stencil, std::int32_t gap_x, std::int32_t gap_z) {
  const bool first_round = gap_x == stencil.gap_x();
  Ring ring{gap_z, gap_z, first_round ? -1 : stencil.reach(gap_z, gap_x + 1), stencil.reach(gap_z, gap_x)};
  do {
    ++ring.gap_z_end;
  } while (ring.gap_z_end <= stencil.gap_z() && stencil.reach(ring.gap_z_end, gap_x) == ring.outer &&
           (first_round || stencil.reach(ring.gap_z_end, gap_x + 1) == ring.inner));
  return ring;
}

/// Every bit of a row spreads to its two neighbours along x.
void spread(std::uint64_t* row, std::int32_t words) {
  std::uint64_t before = 0;
  std::uint64_t word = row[0];
  for (std::int32_t k = 0; k + 1 < words; ++k) {
    const std::uint64_t after = row[k + 1];
    row[k] = word | (word << 1) | (word >> 1) | (before >> 63) | (after << 63);
    before = word;
    word = after;
  }
  row[words - 1] = word | (word << 1) | (word >> 1) | (before >> 63);
}

/// An obstacle blocks itself whatever the radius. Rows that reach furthest along x come first. Each round spreads all
/// that came so far by one voxel, so that what came in the round of gap_x is spread gap_x + 1 times in the end.
void inflate_tile(const Grid& grid, const Stencil& stencil, Tile& tile) {
  const std::int32_t words = grid.row_words();
  const std::uint64_t* own = grid.obstacle_row(tile.y, tile.z);
  for (std::int32_t k = 0; k < tile.rows * words; ++k) tile.words[k] = own[k];
  for (std::int32_t gap_x = stencil.gap_x(); gap_x >= 0; --gap_x) {
    for (std::int32_t gap_z = 0; gap_z <= stencil.gap_z();) {
      const Ring ring = next_ring(stencil, gap_x, gap_z);
      if (ring.inner < ring.outer) gather_ring(grid, ring, tile);
      gap_z = ring.gap_z_end;
    }
    for (std::int32_t r = 0; r < tile.rows; ++r) spread(tile.words + r * words, words);
  }
}

/// Bits of word k whose voxels lie outside the range: outside the boundary, or padding.
std::uint64_t outside_bits(const IndexRange& range, std::int32_t k) {
  const std::int32_t begin = range.begin - 64 * k;
  const std::int32_t end = range.end - 64 * k;
  const std::uint64_t all = ~std::uint64_t{0};
  if (begin >= end || begin >= 64 || end <= 0) return all;
  const std::uint64_t below = begin > 0 ? ~(all << begin) : 0;
  const std::uint64_t above = end < 64 ? all << end : 0;
  return below | above;
}

/// Where the boundary lets voxels be free.
struct Inside {
  IndexRange y;
  IndexRange z;
  std::uint64_t outside_x[kMaxRowWords];  ///< a row's bits outside
};

Inside inside_of(const Grid& grid) {
  Inside inside;
  const IndexRange x = inside_boundary(grid, 0);
  for (std::int32_t k = 0; k < grid.row_words(); ++k) inside.outside_x[k] = outside_bits(x, k);
  inside.y = inside_boundary(grid, 1);
  inside.z = inside_boundary(grid, 2);
  if (inside.y.begin >= inside.y.end) inside.z.end = inside.z.begin;
  return inside;
}

/// Writes the tile into the blocked layer.
void store_tile(const Tile& tile, const Inside& inside, std::int32_t words, std::uint64_t* out) {
  for (std::int32_t r = 0; r < tile.rows; ++r) {
    for (std::int32_t k = 0; k < words; ++k) out[r * words + k] = tile.words[r * words + k] | inside.outside_x[k];
  }
}

void block_all(std::uint64_t* words, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) words[k] = ~std::uint64_t{0};
}

}  // namespace

void Grid::inflate() noexcept {
  if (!bound()) return;
  const Stencil stencil(spec_);
  const Inside inside = inside_of(*this);
  const std::int32_t tile_rows = kTileWords / row_words_;
  block_all(blocked_, grid_words(spec_.dims) / 2);
  Tile tile;
  for (tile.z = inside.z.begin; tile.z < inside.z.end; ++tile.z) {
    for (tile.y = inside.y.begin; tile.y < inside.y.end; tile.y += tile_rows) {
      const std::int32_t rest = inside.y.end - tile.y;
      tile.rows = rest < tile_rows ? rest : tile_rows;
      inflate_tile(*this, stencil, tile);
      store_tile(tile, inside, row_words_, blocked_ + row(tile.y, tile.z));
    }
  }
  inflated_revision_ = revision_;
}

}  // namespace tern
