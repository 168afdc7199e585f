// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flood/flood_layers.hpp"

#include "grid/bit_rows.hpp"

namespace tern {
namespace {

/// One word of a row after each cell has spread to its neighbours along x.
std::uint64_t spread_word(const std::uint64_t* row, std::int32_t words, std::int32_t k, bool steps) {
  if (!steps) return row[k];
  std::uint64_t spread = row[k] | row[k] << 1 | row[k] >> 1;
  if (k > 0) spread |= row[k - 1] >> 63;
  if (k + 1 < words) spread |= row[k + 1] << 63;
  return spread;
}

/// One word after cells have spread to neighbours `stride` words away, of which there are some if `before` or `after`.
std::uint64_t spread_across(const std::uint64_t* word, std::int32_t stride, bool before, bool after) {
  std::uint64_t spread = word[0];
  if (before) spread |= word[-stride];
  if (after) spread |= word[stride];
  return spread;
}

}  // namespace

void spread_layer(const FloodLattice& lattice, const FloodSteps& steps, const std::uint64_t* free,
                  const std::uint64_t* in, std::uint64_t* out, std::uint64_t* scratch) noexcept {
  const std::int32_t w = lattice.row_words;
  const Voxel& cells = lattice.cells;
  std::uint64_t* const first = scratch;
  std::uint64_t* const level = scratch + lattice.words;
  // Along x, then along y.
  for (std::int32_t r = 0; r < lattice.words; r += w) {
    for (std::int32_t k = 0; k < w; ++k) first[r + k] = spread_word(in + r, w, k, steps.x) & free[r + k];
  }
  for (std::int32_t r = 0; r < lattice.words; ++r) {
    const std::int32_t y = r / w % cells.y;
    level[r] = spread_across(first + r, w, steps.y && y > 0, steps.y && y + 1 < cells.y) & free[r];
  }
  // Along y, then along x.
  for (std::int32_t r = 0; r < lattice.words; ++r) {
    const std::int32_t y = r / w % cells.y;
    first[r] = spread_across(in + r, w, steps.y && y > 0, steps.y && y + 1 < cells.y) & free[r];
  }
  for (std::int32_t r = 0; r < lattice.words; r += w) {
    for (std::int32_t k = 0; k < w; ++k) level[r + k] &= spread_word(first + r, w, k, steps.x);
  }
  const std::int32_t plane = w * cells.y;
  for (std::int32_t z = 0; z < cells.z; ++z) {
    for (std::int32_t r = z * plane; r < (z + 1) * plane; ++r) {
      out[r] = spread_across(level + r, plane, steps.z && z > 0, steps.z && z + 1 < cells.z) & free[r];
    }
  }
}

void keep_box(const FloodLattice& lattice, const Voxel& low, const Voxel& high, std::uint64_t* layer) noexcept {
  const IndexRange along{low.x, high.x + 1};
  for (std::int32_t z = 0; z < lattice.cells.z; ++z) {
    for (std::int32_t y = 0; y < lattice.cells.y; ++y) {
      const bool meets = z >= low.z && z <= high.z && y >= low.y && y <= high.y;
      std::uint64_t* const row = layer + lattice.row(y, z);
      for (std::int32_t k = 0; k < lattice.row_words; ++k) row[k] &= meets ? bits_met(along, k) : 0;
    }
  }
}

bool keep_common(const FloodLattice& lattice, const std::uint64_t* other, std::uint64_t* layer) noexcept {
  std::uint64_t any = 0;
  for (std::int32_t k = 0; k < lattice.words; ++k) {
    layer[k] &= other[k];
    any |= layer[k];
  }
  return any != 0;
}

}  // namespace tern
