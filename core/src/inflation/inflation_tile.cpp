// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Blocked rows are the OR of the obstacle rows around them. In a tile, neighbouring rows are neighbours in memory. Each
// step is therefore one long OR that the compiler vectorises.
#include "inflation/inflation_tile.hpp"

#include "grid/lattice.hpp"

namespace tern {
namespace {

/// Words of the obstacle rows for a tile: a few more than those of the tile itself.
constexpr std::int32_t kColumnWords = kTileWords + 64;
/// The most rows that one pass over the words ORs together.
constexpr int kSources = 5;

/// A part of a round: rows inner < |dy| <= outer of the planes gap_z_begin <= gap_z < gap_z_end.
struct Ring {
  std::int32_t gap_z_begin;
  std::int32_t gap_z_end;
  std::int32_t inner;
  std::int32_t outer;
};

/// Obstacle rows y .. y + rows - 1 within the tile's words: the OR of all planes with gap_z_begin <= gap_z < gap_z_end.
struct Column {
  std::int32_t gap_z_begin;
  std::int32_t gap_z_end;
  std::int32_t y;
  std::int32_t rows;
  bool any;  ///< there is an obstacle; if not, the words have no meaning
  std::uint64_t words[kColumnWords];
};

/// words = the OR of kCount sources and, if kKeep, of the words themselves.
template <int kCount, bool kKeep>
void or_sources(const std::uint64_t* const* sources, std::int32_t count, std::uint64_t* __restrict words) {
  const std::uint64_t* source[kCount];
  for (int s = 0; s < kCount; ++s) source[s] = sources[s];
  for (std::int32_t k = 0; k < count; ++k) {
    std::uint64_t word = kKeep ? words[k] | source[0][k] : source[0][k];
    for (int s = 1; s < kCount; ++s) word |= source[s][k];
    words[k] = word;
  }
}

template <bool kKeep>
void or_rows(const std::uint64_t* const* sources, std::int32_t sources_count, std::int32_t count,
             std::uint64_t* words) {
  switch (sources_count) {
    case 1:
      return or_sources<1, kKeep>(sources, count, words);
    case 2:
      return or_sources<2, kKeep>(sources, count, words);
    case 3:
      return or_sources<3, kKeep>(sources, count, words);
    case 4:
      return or_sources<4, kKeep>(sources, count, words);
    default:
      return or_sources<kSources, kKeep>(sources, count, words);
  }
}

std::int32_t clamp_plane(std::int32_t z, std::int32_t count) {
  return z < 0 ? 0 : (z < count ? z : count - 1);
}

/// Plane number `index` of a column: planes below and above alternate; if the column includes the tile's own plane, it
/// comes last. Planes past the grid are replaced by its outermost plane, which is nearer and blocks at least as much.
std::int32_t plane_of(const Column& column, std::int32_t index, std::int32_t z, std::int32_t planes) {
  const std::int32_t gap = column.gap_z_begin + index / 2;
  if (gap >= column.gap_z_end) return z;
  return clamp_plane(index % 2 == 0 ? z - gap - 1 : z + gap + 1, planes);
}

std::int32_t count_planes(const Column& column) {
  return 2 * (column.gap_z_end - column.gap_z_begin) + (column.gap_z_begin == 0 ? 1 : 0);
}

/// Runs of words that are contiguous both in the layer and in a column.
struct Pieces {
  std::int32_t count;
  std::int32_t words;  ///< words of one run
};

/// ORs the column's planes into its rows, from row `first` on.
void or_planes(const Grid& grid, const InflationTile& tile, std::int32_t first, const Pieces& pieces, Column& column) {
  const std::int32_t planes = count_planes(column);
  for (std::int32_t done = 0; done < planes; done += kSources) {
    const std::int32_t now = planes - done < kSources ? planes - done : kSources;
    const std::uint64_t* sources[kSources];
    for (std::int32_t s = 0; s < now; ++s) {
      const std::int32_t z = plane_of(column, done + s, tile.z, grid.spec().dims.z);
      sources[s] = grid.obstacle_row(column.y + first, z) + tile.first;
    }
    std::uint64_t* words = column.words + first * tile.width;
    for (std::int32_t p = 0; p < pieces.count; ++p, words += pieces.words) {
      if (done == 0) {
        or_rows<false>(sources, now, pieces.words, words);
      } else {
        or_rows<true>(sources, now, pieces.words, words);
      }
      for (std::int32_t s = 0; s < now; ++s) sources[s] += grid.row_words();
    }
  }
}

/// ORs the column's planes into its rows, for a tile with a shift: 64 voxels of each row, from two neighbouring words.
/// Past the ends of a row there are no obstacles.
void or_shifted_planes(const Grid& grid, const InflationTile& tile, const IndexRange& rows, Column& column) {
  const BitRows obstacles = GridAccess::obstacles(grid);
  const std::int32_t planes = count_planes(column);
  const bool has_low = tile.first >= 0;
  const bool has_high = tile.first + 1 < obstacles.row_words;
  const std::ptrdiff_t low_word = has_low ? tile.first : 0;
  const std::ptrdiff_t high_word = has_high ? tile.first + 1 : low_word;
  for (std::int32_t done = 0; done < planes; done += kSources) {
    const std::uint64_t* source[kSources];
    for (std::int32_t s = 0; s < kSources; ++s) {
      // If no planes are left, uses the last one again, which changes nothing.
      const std::int32_t index = done + s < planes ? done + s : planes - 1;
      source[s] = obstacles.row(column.y + rows.begin, plane_of(column, index, tile.z, grid.spec().dims.z));
    }
    std::ptrdiff_t row = 0;
    for (std::int32_t r = rows.begin; r < rows.end; ++r, row += obstacles.row_words) {
      std::uint64_t low = 0;
      std::uint64_t high = 0;
      for (int s = 0; s < kSources; ++s) {
        low |= source[s][row + low_word];
        high |= source[s][row + high_word];
      }
      const std::uint64_t word = (has_low ? low >> tile.shift : 0) | (has_high ? high << (kWordBits - tile.shift) : 0);
      column.words[r] = done == 0 ? word : column.words[r] | word;
    }
  }
}

bool any_bit(const std::uint64_t* words, std::int32_t count) {
  std::uint64_t any = 0;
  for (std::int32_t k = 0; k < count; ++k) any |= words[k];
  return any != 0;
}

/// Fills the words of a column whose ranges of planes and rows are set. Rows past the grid are empty.
void gather_column(const Grid& grid, const InflationTile& tile, Column& column) {
  const std::int32_t past = grid.spec().dims.y - column.y;
  const IndexRange rows{column.y < 0 ? -column.y : 0, past < column.rows ? past : column.rows};
  column.any = false;
  if (rows.begin >= rows.end) return;
  const std::int32_t width = tile.width;
  const std::int32_t count = rows.end - rows.begin;
  const bool whole = width == grid.row_words();
  if (tile.shift != 0) {
    or_shifted_planes(grid, tile, rows, column);
  } else {
    or_planes(grid, tile, rows.begin, whole ? Pieces{1, count * width} : Pieces{count, width}, column);
  }
  column.any = any_bit(column.words + rows.begin * width, count * width);
  for (std::int32_t k = 0; k < rows.begin * width; ++k) column.words[k] = 0;
  for (std::int32_t k = rows.end * width; k < column.rows * width; ++k) column.words[k] = 0;
}

/// ORs into each row of the tile the column's rows at distances begin <= dy < end; none if end <= begin.
void add_span(const Column& column, std::int32_t begin, std::int32_t end, InflationTile& tile) {
  if (end <= begin) return;
  const std::uint64_t* rows = column.words + (tile.y + begin - column.y) * tile.width;
  for (std::int32_t left = end - begin; left > 0; left -= kSources) {
    const std::uint64_t* sources[kSources];
    for (int s = 0; s < kSources && s < left; ++s, rows += tile.width) sources[s] = rows;
    or_rows<true>(sources, left < kSources ? left : kSources, tile.rows * tile.width, tile.words[tile.made] + 1);
  }
}

/// Adds the part of the ring with begin <= dy < end. The column must hold these rows.
void add_ring(const Ring& ring, const Column& column, std::int32_t begin, std::int32_t end, InflationTile& tile) {
  if (!column.any) return;
  if (ring.inner < 0) return add_span(column, begin, end, tile);
  add_span(column, begin, end < -ring.inner ? end : -ring.inner, tile);
  add_span(column, begin > ring.inner ? begin : ring.inner + 1, end, tile);
}

bool holds(const Column& column, const Ring& ring) {
  return column.gap_z_begin == ring.gap_z_begin && column.gap_z_end == ring.gap_z_end;
}

/// Adds a ring to the tile, one column's span of dy at a time. A column that holds all rows that its planes can ever
/// reach is kept for the next round.
void gather_ring(const Grid& grid, const Stencil& stencil, const Ring& ring, InflationTile& tile, Column& column) {
  const std::int32_t longest = kColumnWords / tile.width - tile.rows + 1;
  const std::int32_t reach = stencil.reach(ring.gap_z_begin, 0);
  const bool stays = 2 * reach + 1 <= longest;
  const std::int32_t span = stays ? reach : ring.outer;
  for (std::int32_t begin = -span; begin <= span; begin += longest) {
    const std::int32_t end = begin + longest <= span ? begin + longest : span + 1;
    if (begin >= -ring.inner && end <= ring.inner + 1) continue;
    if (!stays || !holds(column, ring)) {
      column.gap_z_begin = ring.gap_z_begin;
      column.gap_z_end = ring.gap_z_end;
      column.y = tile.y + begin;
      column.rows = tile.rows + end - begin - 1;
      gather_column(grid, tile, column);
    }
    add_ring(ring, column, begin < -ring.outer ? -ring.outer : begin, end > ring.outer ? ring.outer + 1 : end, tile);
  }
}

/// The next ring of a round, from plane gap gap_z on. Planes of equal reach form one ring. Rows that reach further
/// along x were added in an earlier round.
Ring next_ring(const Stencil& stencil, std::int32_t gap_x, std::int32_t gap_z) {
  const bool first_round = gap_x == stencil.gap_x();
  Ring ring{gap_z, gap_z, first_round ? -1 : stencil.reach(gap_z, gap_x + 1), stencil.reach(gap_z, gap_x)};
  do {
    ++ring.gap_z_end;
  } while (ring.gap_z_end <= stencil.gap_z() && stencil.reach(ring.gap_z_end, gap_x) == ring.outer &&
           (first_round || stencil.reach(ring.gap_z_end, gap_x + 1) == ring.inner));
  return ring;
}

/// Makes the first and the last bit of each row from the row's own words. Neighbouring rows may have spread into them.
void part_rows(const InflationTile& tile, const std::uint64_t* from, std::uint64_t* to) {
  constexpr std::uint64_t kLow = 1;
  constexpr std::uint64_t kHigh = std::uint64_t{1} << 63;
  for (std::int32_t r = 0; r < tile.rows; ++r) {
    const std::int32_t first = r * tile.width;
    const std::int32_t last = first + tile.width - 1;
    to[first] &= ~kLow | from[first] | (from[first] >> 1);
    to[last] &= ~kHigh | from[last] | (from[last] << 1);
  }
}

/// Spreads every bit to its two neighbours along x, as if all rows were one long row. Rows of one word that do not
/// spread into each other need no bits of their neighbours.
void spread(InflationTile& tile) {
  const std::int32_t count = tile.rows * tile.width;
  const std::uint64_t* __restrict from = tile.words[tile.made] + 1;
  std::uint64_t* __restrict to = tile.words[1 - tile.made] + 1;
  tile.made = 1 - tile.made;
  if (tile.width == 1 && tile.apart) {
    for (std::int32_t k = 0; k < count; ++k) to[k] = from[k] | (from[k] << 1) | (from[k] >> 1);
    return;
  }
  for (std::int32_t k = 0; k < count; ++k) {
    to[k] = from[k] | (from[k] << 1) | (from[k] >> 1) | (from[k - 1] >> 63) | (from[k + 1] << 63);
  }
  if (!tile.apart) part_rows(tile, from, to);
}

/// Copies the obstacle rows into the tile. Without a radius, obstacles block only themselves.
void copy_rows(const Grid& grid, InflationTile& tile) {
  for (std::int32_t r = 0; r < tile.rows; ++r) {
    const std::uint64_t* own = grid.obstacle_row(tile.y + r, tile.z) + tile.first;
    for (std::int32_t k = 0; k < tile.width; ++k) tile.words[0][1 + r * tile.width + k] = own[k];
  }
}

void clear_rows(InflationTile& tile) {
  const std::int32_t end = tile.rows * tile.width + 2;
  for (std::int32_t k = 0; k < end; ++k) tile.words[0][k] = 0;
  tile.words[1][0] = tile.words[1][end - 1] = 0;
}

}  // namespace

/// Obstacle rows that reach furthest along x come first. Each round spreads everything added so far by one voxel. In
/// the end, rows added in the round of gap_x have been spread gap_x + 1 times.
void make_inflation_tile(const Grid& grid, const Stencil& stencil, InflationTile& tile) noexcept {
  tile.made = 0;
  if (stencil.gap_x() < 0) return copy_rows(grid, tile);
  clear_rows(tile);
  Column column;
  column.gap_z_begin = column.gap_z_end = 0;
  for (std::int32_t gap_x = stencil.gap_x(); gap_x >= 0; --gap_x) {
    for (std::int32_t gap_z = 0; gap_z <= stencil.gap_z();) {
      const Ring ring = next_ring(stencil, gap_x, gap_z);
      if (ring.inner < ring.outer) gather_ring(grid, stencil, ring, tile, column);
      gap_z = ring.gap_z_end;
    }
    spread(tile);
  }
}

}  // namespace tern
