// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "inflation/patch_maker.hpp"

#include "base/work.hpp"
#include "grid/changes.hpp"
#include "grid/lattice.hpp"
#include "inflation/inflation_tile.hpp"

namespace tern {
namespace {

/// Rows of the ball in the planes on one side of a voxel.
int rows_of_ball(const Stencil& stencil) {
  int rows = 0;
  for (std::int32_t gap = 0; gap <= stencil.gap_z(); ++gap) rows += 2 * stencil.reach(gap, 0) + 1;
  return rows;
}

void copy(const std::uint64_t* __restrict from, std::int32_t count, std::uint64_t* __restrict to) {
  for (std::int32_t k = 0; k < count; ++k) to[k] = from[k];
}

}  // namespace

PatchMaker::PatchMaker(const Grid& grid, const Stencil& stencil, std::uint64_t* blocked) noexcept
    : grid_(grid),
      stencil_(stencil),
      rows_(GridAccess::obstacles(grid)),
      blocked_(blocked),
      reach_x_(stencil.gap_x() + 1),
      rows_inside_(inside_boundary(grid, 1)),
      planes_inside_(inside_boundary(grid, 2)) {
  const IndexRange x = inside_boundary(grid, 0);
  for (std::int32_t k = 0; k < rows_.row_words; ++k) outside_x_[k] = ~bits_met(x, k);
  // Each round of a tile goes through the planes of the ball. All rounds together add each row of the ball to each
  // word.
  tile_operations_ = ops::kPiece * (3 + 2 * (stencil.gap_x() + 1) * (stencil.gap_z() + 1));
  word_operations_ = ops::kWord * (3 + rows_of_ball(stencil));
}

Operations PatchMaker::make_operations(const Patch& patch) const noexcept {
  const IndexRange words = with_halo(patch.words);
  const std::int32_t width = words.end - words.begin;
  const std::int32_t rows = patch.rows.end - patch.rows.begin;
  const std::int32_t tile_rows = kTileWords / width;
  // Whole rows are contiguous and cost less.
  const Operations word = width == rows_.row_words ? word_operations_ * 2 / 3 : word_operations_;
  return ops::kPiece + tile_operations_ * ((rows + tile_rows - 1) / tile_rows) + word * rows * width;
}

/// A word has at most eight runs of rows (see without_gaps in inflate.cpp). Each is copied from below, and made.
Operations PatchMaker::most_operations() const noexcept {
  constexpr Operations kRuns = 8;
  const Operations width = 1 + 2 * words_for(reach_x_);
  const Operations tiles = kRuns + kStripRows * width / kTileWords + 1;
  return 2 * kRuns * ops::kPiece + tiles * tile_operations_ + kStripRows * (width * word_operations_ + 7 * ops::kWord);
}

/// True if rows do not spread into each other: each ends in enough padding, or the words have a halo on both sides.
bool PatchMaker::rows_apart(std::int32_t first, std::int32_t end) const noexcept {
  if (end < rows_.row_words) return first > 0;
  return kWordBits * rows_.row_words - grid_.spec().dims.x > reach_x_;
}

/// The patch's words and, on both sides, the words whose obstacles can block voxels of the patch.
IndexRange PatchMaker::with_halo(const IndexRange& words) const noexcept {
  const std::int32_t halo = words_for(reach_x_);
  return overlap({0, rows_.row_words}, {words.begin - halo, words.end + halo});
}

void PatchMaker::make(const Patch& patch, Work& work) const noexcept {
  work.spend(make_operations(patch));
  const IndexRange words = with_halo(patch.words);
  InflationTile tile;
  tile.z = patch.z;
  tile.first = words.begin;
  tile.shift = 0;
  tile.width = words.end - words.begin;
  tile.apart = rows_apart(words.begin, words.end);
  const std::int32_t tile_rows = kTileWords / tile.width;
  for (tile.y = patch.rows.begin; tile.y < patch.rows.end; tile.y += tile_rows) {
    tile.rows = patch.rows.end - tile.y < tile_rows ? patch.rows.end - tile.y : tile_rows;
    make_inflation_tile(grid_, stencil_, tile);
    store(tile, patch.words);
  }
}

/// Writes these words of the tile's rows into the blocked layer.
void PatchMaker::store(const InflationTile& tile, const IndexRange& words) const noexcept {
  std::uint64_t* row = blocked_ + rows_.index(tile.y, tile.z);
  const std::int32_t width = words.end - words.begin;
  if (width == rows_.row_words) {
    copy(tile.row(0), tile.rows * width, row);
  } else {
    for (std::int32_t r = 0; r < tile.rows; ++r) {
      copy(tile.row(r) + words.begin - tile.first, width, row + r * rows_.row_words + words.begin);
    }
  }
  // Only a few words of a row lie partly outside the boundary.
  for (std::int32_t k = words.begin; k < words.end; ++k) {
    for (std::int32_t r = 0; r < tile.rows && outside_x_[k] != 0; ++r) row[r * rows_.row_words + k] |= outside_x_[k];
  }
}

void PatchMaker::make_narrow(const Patch& patch, const IndexRange& x, Work& work) const noexcept {
  work.spend(ops::kPiece + tile_operations_ +
             (4 * ops::kWord + word_operations_) * (patch.rows.end - patch.rows.begin));
  InflationTile tile;
  tile.y = patch.rows.begin;
  tile.z = patch.z;
  tile.rows = patch.rows.end - patch.rows.begin;
  tile.first = (x.begin - reach_x_) >> 6;
  tile.shift = (x.begin - reach_x_) & 63;
  tile.width = 1;
  tile.apart = true;
  make_inflation_tile(grid_, stencil_, tile);
  for (std::int32_t k = patch.words.begin; k < patch.words.end; ++k) store_narrow(tile, x, k);
}

/// Writes the voxels of the tile that lie both in the range and in word k.
void PatchMaker::store_narrow(const InflationTile& tile, const IndexRange& x, std::int32_t k) const noexcept {
  const std::uint64_t kept = ~bits_met(x, k);
  const std::int32_t left = kWordBits * (tile.first - k) + tile.shift;
  std::uint64_t* word = blocked_ + rows_.index(tile.y, tile.z) + k;
  for (std::int32_t r = 0; r < tile.rows; ++r, word += rows_.row_words) {
    const std::uint64_t made = left < 0 ? *tile.row(r) >> -left : *tile.row(r) << left;
    *word = (*word & kept) | (made & ~kept) | outside_x_[k];
  }
}

void PatchMaker::copy_below(const Patch& patch, Work& work) const noexcept {
  const std::int32_t width = patch.words.end - patch.words.begin;
  const std::int32_t count = patch.rows.end - patch.rows.begin;
  work.spend(ops::kPiece + (2 * ops::kTurn + ops::kWord * width) * count);
  const std::ptrdiff_t plane = rows_.index(0, 1);
  std::uint64_t* row = blocked_ + rows_.index(patch.rows.begin, patch.z) + patch.words.begin;
  if (width == rows_.row_words) return copy(row - plane, count * width, row);
  for (std::int32_t r = 0; r < count; ++r, row += rows_.row_words) copy(row - plane, width, row);
}

}  // namespace tern
