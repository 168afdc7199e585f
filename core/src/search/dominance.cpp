// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "search/dominance.hpp"

#include "grid/bit_rows.hpp"

namespace tern {

void dominance_reset(DominanceMap& map, const Grid& grid) noexcept {
  const Voxel& dims = grid.spec().dims;
  map.width = (dims.x + 3) / 4;
  map.slice = map.width * ((dims.y + 3) / 4);
  const std::int64_t blocks = std::int64_t{map.slice} * ((dims.z + 3) / 4);
  const std::int64_t used = blocks < kDominanceBlocks ? blocks : kDominanceBlocks;
  for (std::int64_t k = 0; k <= used / 64; ++k) map.known[k] = 0;
}

// A block's rows lie within one word.
bool block_box_free(const Grid& grid, const Voxel& a, const Voxel& b) noexcept {
  const std::int32_t first_x = a.x < b.x ? a.x : b.x;
  const std::int32_t last_x = a.x < b.x ? b.x : a.x;
  const std::int32_t first_y = a.y < b.y ? a.y : b.y;
  const std::int32_t last_y = a.y < b.y ? b.y : a.y;
  const std::int32_t first_z = a.z < b.z ? a.z : b.z;
  const std::int32_t last_z = a.z < b.z ? b.z : a.z;
  const std::uint64_t mask = ((std::uint64_t{2} << (last_x - first_x)) - 1) << (first_x & 63);
  const BitRows rows = GridView::blocked(grid);
  std::uint64_t blocked = 0;
  for (std::int32_t z = first_z; z <= last_z; ++z) {
    for (std::int32_t y = first_y; y <= last_y; ++y) blocked |= rows.row(y, z)[first_x >> 6];
  }
  return (blocked & mask) == 0;
}

}  // namespace tern
