// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flood/flood_lattice.hpp"

#include "grid/lattice.hpp"

namespace tern {
namespace {

/// Voxels of a cell along an axis: fewer if the boundary holds fewer.
std::int32_t edge_along(const FloodLattice& lattice, const Grid& grid, int a) {
  const IndexRange inside = inside_boundary(grid, a);
  const std::int32_t count = inside.end - inside.begin;
  return count < lattice.edge ? count : lattice.edge;
}

/// The bits [begin, begin + count) of a row's words, count <= 64.
bool any_bit(const std::uint64_t* words, std::int32_t begin, std::int32_t count) {
  const std::int32_t shift = begin & 63;
  std::uint64_t bits = words[begin >> 6] >> shift;
  if (shift + count > kWordBits) bits |= words[(begin >> 6) + 1] << (kWordBits - shift);
  return (bits & (kAllBits >> (kWordBits - count))) != 0;
}

void count_words(FloodLattice& lattice) {
  lattice.row_words = words_for(lattice.cells.x);
  lattice.words = lattice.row_words * lattice.cells.y * lattice.cells.z;
}

}  // namespace

FloodLattice lay_out(const Grid& grid, const Vec3& middle, std::int32_t edge) noexcept {
  FloodLattice lattice{};
  lattice.edge = edge;
  lattice.size = edge * grid.spec().cell;
  const Voxel home = grid.voxel_of(middle);
  for (int a = 0; a < 3; ++a) {
    const IndexRange inside = inside_boundary(grid, a);
    const std::int32_t count = inside.end - inside.begin;
    const std::int32_t offset = axis(home, a) - edge / 2 - inside.begin;
    const std::int32_t skipped = offset >= 0 ? offset % edge : 0;
    const std::int32_t cells = (count - skipped) / edge;
    axis(lattice.low, a) = inside.begin + (cells > 0 ? skipped : 0);
    axis(lattice.cells, a) = cells > 0 ? cells : 1;
  }
  count_words(lattice);
  return lattice;
}

Voxel cell_at(const FloodLattice& lattice, const Grid& grid, const Vec3& point) noexcept {
  Voxel cell{};
  for (int a = 0; a < 3; ++a) {
    const double along = axis(point, a) - axis(lattice.low, a) * grid.spec().cell;
    axis(cell, a) = floor_index(along / lattice.size, 0, axis(lattice.cells, a) - 1);
  }
  return cell;
}

void keep_cells_between(const Grid& grid, const Vec3& from, const Vec3& to, const Voxel& steps,
                        FloodLattice& lattice) noexcept {
  const Voxel start = cell_at(lattice, grid, from);
  const Voxel goal = cell_at(lattice, grid, to);
  for (int a = 0; a < 3; ++a) {
    const bool leads_up = axis(start, a) <= axis(goal, a);
    const std::int32_t first = axis(leads_up ? start : goal, a);
    const std::int32_t last = axis(leads_up ? goal : start, a);
    const std::int32_t spare = (axis(steps, a) - (last - first)) / 2;
    const std::int32_t further = spare > 0 ? spare : 0;
    const std::int32_t low = first > further ? first - further : 0;
    const std::int32_t high = last + further < axis(lattice.cells, a) ? last + further : axis(lattice.cells, a) - 1;
    axis(lattice.low, a) += lattice.edge * low;
    axis(lattice.cells, a) = high - low + 1;
  }
  count_words(lattice);
}

Vec3 middle_of(const FloodLattice& lattice, const Grid& grid, const Voxel& cell) noexcept {
  const Box boundary = grid.local_boundary();
  Vec3 point{};
  for (int a = 0; a < 3; ++a) {
    const double half = 0.5 * edge_along(lattice, grid, a);
    const double at = (axis(lattice.low, a) + lattice.edge * axis(cell, a) + half) * grid.spec().cell;
    axis(point, a) = clamp(at, axis(boundary.lower, a), axis(boundary.upper, a));
  }
  return point;
}

Operations fill_free_row(const FloodLattice& lattice, const Grid& grid, std::int32_t y, std::int32_t z,
                         std::uint64_t* layer) noexcept {
  const BitRows blocked = GridAccess::blocked(grid);
  const std::int32_t across = edge_along(lattice, grid, 1);
  const std::int32_t up = edge_along(lattice, grid, 2);
  const std::int32_t along = edge_along(lattice, grid, 0);
  std::uint64_t any[kMaxRowWords + 1] = {};
  for (std::int32_t dz = 0; dz < up; ++dz) {
    for (std::int32_t dy = 0; dy < across; ++dy) {
      const std::uint64_t* const row =
          blocked.row(lattice.low.y + lattice.edge * y + dy, lattice.low.z + lattice.edge * z + dz);
      for (std::int32_t k = 0; k < blocked.row_words; ++k) any[k] |= row[k];
    }
  }
  std::uint64_t* const out = layer + lattice.row(y, z);
  for (std::int32_t k = 0; k < lattice.row_words; ++k) out[k] = 0;
  for (std::int32_t x = 0; x < lattice.cells.x; ++x) {
    if (!any_bit(any, lattice.low.x + lattice.edge * x, along)) out[x >> 6] |= std::uint64_t{1} << (x & 63);
  }
  return ops::kRow * across * up + ops::kWord * blocked.row_words * (across * up + 1) + ops::kTurn * lattice.cells.x;
}

}  // namespace tern
