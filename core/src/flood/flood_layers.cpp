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

/// out = the free cells of `count` rows of so many words after each cell has spread to the rows beside its own.
void spread_rows(const std::uint64_t* in, const std::uint64_t* free, std::int32_t words, std::int32_t count, bool steps,
                 std::uint64_t* out) {
  for (std::int32_t row = 0; row < count; ++row) {
    const bool before = steps && row > 0;
    const bool after = steps && row + 1 < count;
    const std::uint64_t* const own = in + row * words;
    for (std::int32_t k = 0; k < words; ++k) {
      std::uint64_t spread = own[k];
      if (before) spread |= own[k - words];
      if (after) spread |= own[k + words];
      out[row * words + k] = spread & free[row * words + k];
    }
  }
}

}  // namespace

void spread_layer(const FloodLattice& lattice, const FloodSteps& steps, const std::uint64_t* free,
                  const std::uint64_t* in, std::uint64_t* out, std::uint64_t* scratch) noexcept {
  const std::int32_t w = lattice.row_words;
  const Voxel& cells = lattice.cells;
  const std::int32_t plane = w * cells.y;
  std::uint64_t* const by_x = scratch;
  std::uint64_t* const level = scratch + lattice.words;
  // Along x, then along y.
  for (std::int32_t r = 0; r < lattice.words; r += w) {
    for (std::int32_t k = 0; k < w; ++k) by_x[r + k] = spread_word(in + r, w, k, steps.x) & free[r + k];
  }
  for (std::int32_t z = 0; z < lattice.words; z += plane)
    spread_rows(by_x + z, free + z, w, cells.y, steps.y, level + z);
  // Along y, then along x.
  std::uint64_t* const by_y = scratch;
  for (std::int32_t z = 0; z < lattice.words; z += plane) spread_rows(in + z, free + z, w, cells.y, steps.y, by_y + z);
  for (std::int32_t r = 0; r < lattice.words; r += w) {
    for (std::int32_t k = 0; k < w; ++k) level[r + k] &= spread_word(by_y + r, w, k, steps.x);
  }
  spread_rows(level, free, plane, cells.z, steps.z, out);
}

void keep_box(const FloodLattice& lattice, const Voxel& low, const Voxel& high, std::uint64_t* layer) noexcept {
  const Voxel& cells = lattice.cells;
  const bool keeps_all =
      low.x <= 0 && low.y <= 0 && low.z <= 0 && high.x >= cells.x - 1 && high.y >= cells.y - 1 && high.z >= cells.z - 1;
  if (keeps_all) return;
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
