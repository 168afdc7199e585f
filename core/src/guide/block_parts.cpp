// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "guide/block_parts.hpp"

#include "grid/bit_rows.hpp"

namespace tern {
namespace {

constexpr VoxelMask kFaces[kSides] = {0x1111111111111111u, 0x8888888888888888u, 0x000F000F000F000Fu,
                                      0xF000F000F000F000u, 0x000000000000FFFFu, 0xFFFF000000000000u};

/// The voxels and free ones beside them, one axis after the other: what came along one axis grows along the next.
VoxelMask grown(VoxelMask voxels, VoxelMask free) {
  voxels |= ((voxels & ~kFaces[1]) << 1 | (voxels & ~kFaces[0]) >> 1) & free;
  voxels |= ((voxels & ~kFaces[3]) << 4 | (voxels & ~kFaces[2]) >> 4) & free;
  return voxels | ((voxels << 16 | voxels >> 16) & free);
}

}  // namespace

VoxelMask block_voxels(const Grid& grid, const Voxel& block) noexcept {
  const Voxel& dims = grid.spec().dims;
  const BitRows blocked = GridView::blocked(grid);
  const Voxel first{block.x * 4, block.y * 4, block.z * 4};
  const int layers = dims.z - first.z < 4 ? dims.z - first.z : 4;
  const int rows = dims.y - first.y < 4 ? dims.y - first.y : 4;
  VoxelMask voxels = 0;
  for (int z = 0; z < layers; ++z) {
    const std::uint64_t* row = blocked.row(first.y, first.z + z) + (first.x >> 6);
    for (int y = 0; y < rows; ++y, row += blocked.row_words) {
      voxels |= (~row[0] >> (first.x & 63) & 15u) << (4 * y + 16 * z);
    }
  }
  return voxels;
}

VoxelMask connected(VoxelMask seeds, VoxelMask free) noexcept {
  VoxelMask reached = seeds & free;
  // Each round but the last adds a voxel.
  for (int k = 0; k < 64; ++k) {
    const VoxelMask more = grown(reached, free);
    if (more == reached) break;
    reached = more;
  }
  return reached;
}

bool one_part(VoxelMask free) noexcept {
  return connected(free & (~free + 1), free) == free;
}

SideMask sides_touched(VoxelMask voxels) noexcept {
  SideMask sides = 0;
  for (int side = 0; side < kSides; ++side) sides |= (voxels & kFaces[side]) != 0 ? 1u << side : 0u;
  return sides;
}

VoxelMask voxels_at(SideMask sides) noexcept {
  VoxelMask voxels = 0;
  for (int side = 0; side < kSides; ++side) voxels |= (sides >> side & 1u) != 0 ? kFaces[side] : 0;
  return voxels;
}

VoxelMask voxels_across(VoxelMask voxels, int side) noexcept {
  constexpr int kWidth[] = {3, 12, 48};  // from a face to the opposite one
  const VoxelMask here = voxels & kFaces[side];
  return side % 2 == 0 ? here << kWidth[side / 2] : here >> kWidth[side / 2];
}

}  // namespace tern
