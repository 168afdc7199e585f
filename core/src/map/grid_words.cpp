// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/grid_words.hpp"

#include "base/math.hpp"
#include "grid/changes.hpp"
#include "grid/lattice.hpp"
#include "map/map_state.hpp"

namespace tern {
namespace {

/// The number that stands for a slide in the content number; marks have other numbers.
constexpr std::uint64_t kShifted = ~std::uint64_t{1};

}  // namespace

void GridWords::store(std::int32_t y, std::int32_t z, std::int32_t k, std::uint64_t word) const noexcept {
  const std::size_t at = grid_.row(y, z) + static_cast<std::size_t>(k);
  const std::uint64_t flips = grid_.obstacles_[at] ^ word;
  if (flips == 0) return;
  std::uint64_t* header = grid_.words_;
  if (header[Grid::kInflated] == header[Grid::kRevision]) ++header[Grid::kRevision];
  header[Grid::kContent] = content_after(content_after(header[Grid::kContent], at), flips);
  grid_.obstacles_[at] = word;
  const std::int32_t first = 64 * k + __builtin_ctzll(flips) - grid_.reach_x_;
  const std::int32_t last = 64 * k + 63 - __builtin_clzll(flips) + grid_.reach_x_;
  note(y, z, first < 0 ? 0 : first >> 6, last < grid_.spec_.dims.x ? last >> 6 : grid_.row_words_ - 1);
}

void GridWords::note(std::int32_t y, std::int32_t z, std::int32_t first, std::int32_t last) const noexcept {
  Changes(grid_.spec_.dims, grid_.changes_).note(y, z, first, last);
}

std::int32_t GridWords::inflation_pieces(const Voxel& dims) noexcept {
  return (dims.z + kInflatedPlanes - 1) / kInflatedPlanes * words_for(dims.y);
}

void GridWords::inflate_piece(std::int32_t piece, Work& work) const noexcept {
  const Voxel& dims = grid_.spec_.dims;
  const std::int32_t strips = words_for(dims.y);
  const std::int32_t begin = piece / strips * kInflatedPlanes;
  const std::int32_t end = begin + kInflatedPlanes < dims.z ? begin + kInflatedPlanes : dims.z;
  grid_.inflate_planes(begin, end, piece % strips, piece % strips + 1, work);
  if (piece + 1 == inflation_pieces(dims)) finish_inflation();
}

void GridWords::finish_inflation() const noexcept {
  Changes(grid_.spec_.dims, grid_.changes_).clear();
  grid_.words_[Grid::kInflated] = grid_.words_[Grid::kRevision];
}

void GridWords::begin_copy(const Grid& from) const noexcept {
  begin_shift();
  if (same(grid_.spec_.origin, from.spec_.origin)) return;
  move_to(from.spec_.origin);
  grid_.binding_ = content_after(grid_.binding_, grid_.words_[Grid::kRevision]);
}

void GridWords::copy_planes(const Grid& from, std::int32_t begin, std::int32_t end) const noexcept {
  const std::size_t first = grid_.row(0, begin);
  const std::size_t bytes = sizeof(std::uint64_t) * (grid_.row(0, end) - first);
  __builtin_memcpy(grid_.obstacles_ + first, from.obstacles_ + first, bytes);
  __builtin_memcpy(grid_.blocked_ + first, from.blocked_ + first, bytes);
}

void GridWords::end_copy(const Grid& from) const noexcept {
  grid_.words_[Grid::kContent] = from.words_[Grid::kContent];
  finish_inflation();
  grid_.words_[Grid::kBinding] = grid_.binding_;
}

void GridWords::begin_shift() const noexcept {
  grid_.words_[Grid::kBinding] = ~grid_.binding_;
  ++grid_.words_[Grid::kRevision];
}

void GridWords::move_to(const Vec3& origin) const noexcept {
  GridSpec& spec = grid_.spec_;
  spec.origin = origin;
  spec.boundary = window_box(origin, spec.cell, spec.dims);
}

void GridWords::end_shift(const Voxel& by) const noexcept {
  std::uint64_t* header = grid_.words_;
  std::uint64_t content = content_after(header[Grid::kContent], kShifted);
  for (int a = 0; a < 3; ++a) content = content_after(content, static_cast<std::uint64_t>(std::int64_t{axis(by, a)}));
  header[Grid::kContent] = content;
  grid_.binding_ = content_after(grid_.binding_, content ^ header[Grid::kRevision]);
  header[Grid::kBinding] = grid_.binding_;
}

}  // namespace tern
