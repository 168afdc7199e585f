// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Inflation, 64 voxels a word. A word of the blocked layer depends on obstacles nearby only, so that only words near
// changed ones are made again. After bind() all have changed.
#include "grid/changes.hpp"
#include "grid/inflation_tile.hpp"
#include "grid/lattice.hpp"
#include "grid/stencil.hpp"
#include "tern/grid.hpp"

namespace tern {
namespace {

/// Where the boundary lets voxels be free.
struct Inside {
  IndexRange y;
  IndexRange z;
  std::uint64_t outside_x[kMaxRowWords];  ///< a row's bits outside
};

/// Bits from index `begin` up to `end` of a word that begins at index 64 k.
std::uint64_t bits_in(const IndexRange& range, std::int32_t k) {
  const std::int32_t begin = range.begin - 64 * k;
  const std::int32_t end = range.end - 64 * k;
  const std::uint64_t all = ~std::uint64_t{0};
  if (begin >= end || begin >= 64 || end <= 0) return 0;
  const std::uint64_t below = begin > 0 ? ~(all << begin) : 0;
  const std::uint64_t above = end < 64 ? all << end : 0;
  return ~(below | above);
}

Inside inside_of(const Grid& grid) {
  Inside inside;
  const IndexRange x = inside_boundary(grid, 0);
  for (std::int32_t k = 0; k < grid.row_words(); ++k) inside.outside_x[k] = ~bits_in(x, k);
  inside.y = inside_boundary(grid, 1);
  inside.z = inside_boundary(grid, 2);
  return inside;
}

/// The middle one of three words after each bit has spread by `reach` < 64 to both sides.
std::uint64_t spread_rows(std::uint64_t before, std::uint64_t own, std::uint64_t after, std::int32_t reach) {
  std::uint64_t up = own;
  std::uint64_t down = own;
  for (std::int32_t done = 0; done < reach;) {
    const std::int32_t step = done + 1 < reach - done ? done + 1 : reach - done;
    up |= up << step | before >> (64 - step);
    before |= before << step;
    down |= down >> step | after << (64 - step);
    after |= after >> step;
    done += step;
  }
  return up | down;
}

/// Adds to reached[k] the block's rows that changes of plane z reach in word k. Beyond 64 rows whole blocks count as
/// reached.
void add_reached(const Changes& changes, std::int32_t z, std::int32_t block, std::int32_t reach,
                 const IndexRange& words, std::uint64_t* reached) {
  if (!changes.plane(z)) return;
  const std::int32_t far = reach < kBlockRows ? 1 : (reach + kBlockRows - 1) / kBlockRows;
  for (std::int32_t k = words.begin; k < words.end; ++k) {
    std::uint64_t any = 0;
    for (std::int32_t b = block - far; b <= block + far; ++b) any |= changes.rows(z, b, k);
    if (any == 0) continue;
    reached[k] |= reach < kBlockRows ? spread_rows(changes.rows(z, block - 1, k), changes.rows(z, block, k),
                                                   changes.rows(z, block + 1, k), reach)
                                     : ~std::uint64_t{0};
  }
}

/// The block's rows of plane z to be made again, for each word.
void find_reached(const Changes& changes, const Stencil& stencil, std::int32_t z, std::int32_t block,
                  const IndexRange& words, std::uint64_t* reached) {
  for (std::int32_t k = words.begin; k < words.end; ++k) reached[k] = 0;
  add_reached(changes, z, block, stencil.gap_z() < 0 ? 0 : stencil.reach(0, 0), words, reached);
  for (std::int32_t gap = 0; gap <= stencil.gap_z(); ++gap) {
    const std::int32_t reach = stencil.reach(gap, 0);
    add_reached(changes, z - gap - 1, block, reach, words, reached);
    add_reached(changes, z + gap + 1, block, reach, words, reached);
  }
}

/// A rectangle of the blocked layer to be made again, in one plane.
struct Patch {
  std::int32_t z;
  IndexRange rows;
  IndexRange words;
};

/// Takes the first run of rows off reached[k], and off the words after it as far as they hold all of it.
Patch take_patch(std::uint64_t* reached, std::int32_t end, std::int32_t k) {
  const std::int32_t begin = __builtin_ctzll(reached[k]);
  const std::uint64_t gaps = ~(reached[k] >> begin);
  const std::int32_t count = gaps == 0 ? kBlockRows : __builtin_ctzll(gaps);
  const std::uint64_t run = bits_in({begin, begin + count}, 0);
  Patch patch{0, {begin, begin + count}, {k, k}};
  while (patch.words.end < end && (reached[patch.words.end] & run) == run) reached[patch.words.end++] &= ~run;
  return patch;
}

void copy(const std::uint64_t* from, std::int32_t count, std::uint64_t* __restrict to) {
  for (std::int32_t k = 0; k < count; ++k) to[k] = from[k];
}

/// Writes the patch's words of the tile into the blocked layer, whose row for the tile's first one is given.
void store_tile(const InflationTile& tile, const Inside& inside, const IndexRange& words, std::int32_t row_words,
                std::uint64_t* row) {
  if (words.end - words.begin == row_words) {
    copy(tile.row(0), tile.rows * row_words, row);
  } else {
    for (std::int32_t r = 0; r < tile.rows; ++r) {
      copy(tile.row(r) + words.begin - tile.first, words.end - words.begin, row + r * row_words + words.begin);
    }
  }
  // Few words of a row reach outside the boundary.
  for (std::int32_t k = words.begin; k < words.end; ++k) {
    for (std::int32_t r = 0; r < tile.rows && inside.outside_x[k] != 0; ++r)
      row[r * row_words + k] |= inside.outside_x[k];
  }
}

IndexRange overlap(const IndexRange& a, const IndexRange& b) {
  return {a.begin > b.begin ? a.begin : b.begin, a.end < b.end ? a.end : b.end};
}

/// One inflation of a grid whose blocked layer is given.
struct Inflation {
  const Grid& grid;
  const Stencil stencil;
  const Inside inside;
  std::uint64_t* blocked;
  std::uint64_t content;    ///< of the obstacle layer
  std::uint64_t* contents;  ///< of the blocked layer's regions: that of the obstacles they were last made from

  /// A row that ends in enough padding, or a window with a halo on both sides, keeps its rows apart.
  bool rows_apart(std::int32_t first, std::int32_t end) const {
    if (end < grid.row_words()) return first > 0;
    return 64 * grid.row_words() - grid.spec().dims.x > stencil.gap_x() + 1;
  }

  void make(const Patch& patch) const {
    const std::int32_t row_words = grid.row_words();
    // Words so far beside the patch reach into it along x.
    const std::int32_t halo = (stencil.gap_x() + kBlockRows) / 64;
    InflationTile tile;
    tile.z = patch.z;
    tile.first = patch.words.begin < halo ? 0 : patch.words.begin - halo;
    tile.width = (patch.words.end + halo < row_words ? patch.words.end + halo : row_words) - tile.first;
    tile.apart = rows_apart(tile.first, tile.first + tile.width);
    const std::int32_t tile_rows = kTileWords / tile.width;
    for (tile.y = patch.rows.begin; tile.y < patch.rows.end; tile.y += tile_rows) {
      tile.rows = patch.rows.end - tile.y < tile_rows ? patch.rows.end - tile.y : tile_rows;
      make_inflation_tile(grid, stencil, tile);
      const std::size_t row = static_cast<std::size_t>(grid.obstacle_row(tile.y, tile.z) - grid.obstacle_row(0, 0));
      store_tile(tile, inside, patch.words, row_words, blocked + row);
    }
  }

  void make_block(const Changes& changes, const IndexRange& words, std::int32_t z, std::int32_t block) const {
    const std::uint64_t rows_inside = bits_in(inside.y, block);
    if (rows_inside == 0) return;
    std::uint64_t reached[kMaxRowWords];
    find_reached(changes, stencil, z, block, words, reached);
    for (std::int32_t k = words.begin; k < words.end; ++k) reached[k] &= rows_inside;
    for (std::int32_t k = words.begin; k < words.end; ++k) {
      while (reached[k] != 0) {
        Patch patch = take_patch(reached, words.end, k);
        patch.z = z;
        patch.rows.begin += block * kBlockRows;
        patch.rows.end += block * kBlockRows;
        make(patch);
        for (std::int32_t w = patch.words.begin; w < patch.words.end; ++w)
          contents[Regions(grid.spec().dims).at(z, block, w)] = content;
      }
    }
  }

  /// Makes what changes reach in the planes of `wanted`.
  void run(const Changes& changes, const IndexRange& wanted) const {
    const ChangeExtent extent = changes.extent();
    const std::int32_t far_z = stencil.gap_z() + 1;
    const std::int32_t far_blocks = stencil.gap_z() < 0 ? 0 : (stencil.reach(0, 0) + kBlockRows - 1) / kBlockRows;
    const IndexRange reached = overlap(inside.z, {extent.planes.begin - far_z, extent.planes.end + far_z});
    const IndexRange planes = overlap(reached, wanted);
    const IndexRange blocks =
        overlap({0, changes.blocks()}, {extent.blocks.begin - far_blocks, extent.blocks.end + far_blocks});
    for (std::int32_t z = planes.begin; z < planes.end; ++z) {
      for (std::int32_t block = blocks.begin; block < blocks.end; ++block) make_block(changes, extent.words, z, block);
    }
  }
};

}  // namespace

void Grid::inflate_planes(std::int32_t begin, std::int32_t end) noexcept {
  const Changes changes(spec_.dims, changes_);
  if (!changes.any()) return;
  const Inflation inflation{*this, Stencil(spec_), inside_of(*this), blocked_, words_[kContent], contents_};
  inflation.run(changes, {begin, end});
}

void Grid::inflate() noexcept {
  if (!bound()) return;
  inflate_planes(0, spec_.dims.z);
  Changes(spec_.dims, changes_).clear();
  words_[kInflated] = words_[kRevision];
}

}  // namespace tern
