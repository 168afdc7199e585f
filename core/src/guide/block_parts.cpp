// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "guide/block_parts.hpp"

#include "grid/bit_rows.hpp"

namespace tern {
namespace {

constexpr VoxelMask kFaces[kSides] = {0x1111111111111111u, 0x8888888888888888u, 0x000F000F000F000Fu,
                                      0xF000F000F000F000u, 0x000000000000FFFFu, 0xFFFF000000000000u};

/// The voxels and the free voxels beside them. Grows along one axis after the other, so that voxels added along one
/// axis also grow along the next.
VoxelMask grown(VoxelMask voxels, VoxelMask free) {
  voxels |= ((voxels & ~kFaces[1]) << 1 | (voxels & ~kFaces[0]) >> 1) & free;
  voxels |= ((voxels & ~kFaces[3]) << 4 | (voxels & ~kFaces[2]) >> 4) & free;
  return voxels | ((voxels << 16 | voxels >> 16) & free);
}

constexpr std::uint64_t rotated(std::uint64_t bits, int left) {
  return bits << left | bits >> ((64 - left) & 63);
}

/// The blocked voxels of a block that has this many layers and rows inside the grid.
inline VoxelMask read_blocked(const Grid& grid, const Voxel& first, int layers, int rows) {
  const BitRows blocked = GridAccess::blocked(grid);
  const std::uint64_t* layer = blocked.row(first.y, first.z) + (first.x >> 6);
  const std::uint64_t wanted = std::uint64_t{15} << (first.x & 63);
  std::uint64_t voxels = 0;  // begins at bit first.x, and wraps around the word's end
  for (int z = 0; z < layers; ++z, layer += blocked.index(0, 1)) {
    std::uint64_t of_layer = 0;
    for (int y = 0; y < rows; ++y) of_layer |= rotated(layer[y * blocked.row_words] & wanted, 4 * y);
    voxels |= rotated(of_layer, 16 * z);
  }
  return rotated(voxels, -first.x & 63);
}

/// True if one side is wholly free, and each free voxel lies on a row of free voxels that begins at that side. All free
/// voxels are then connected. Most blocks are like that.
bool rows_from_a_side(VoxelMask free) {
  constexpr int kStep[] = {1, 4, 16};
  for (int axis = 0; axis < 3; ++axis) {
    const VoxelMask low = kFaces[2 * axis];
    const VoxelMask high = kFaces[2 * axis + 1];
    if ((low & ~free) == 0 && (free & ~(free << kStep[axis] | low)) == 0) return true;
    if ((high & ~free) == 0 && (free & ~(free >> kStep[axis] | high)) == 0) return true;
  }
  return false;
}

}  // namespace

VoxelMask block_voxels(const Grid& grid, const Voxel& block) noexcept {
  const Voxel& dims = grid.spec().dims;
  const Voxel first{block.x * 4, block.y * 4, block.z * 4};
  // Most blocks lie wholly inside the grid. For them, the bounds of the loops are constants.
  if (first.y + 4 <= dims.y && first.z + 4 <= dims.z) return ~read_blocked(grid, first, 4, 4);
  const int layers = dims.z - first.z < 4 ? dims.z - first.z : 4;
  const int rows = dims.y - first.y < 4 ? dims.y - first.y : 4;
  const VoxelMask inside = ~VoxelMask{0} >> 16 * (4 - layers) & 0x0001000100010001u * (0xFFFFu >> 4 * (4 - rows));
  return inside & ~read_blocked(grid, first, layers, rows);
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
  return rows_from_a_side(free) || connected(free & (~free + 1), free) == free;
}

SideMask sides_touched(VoxelMask voxels) noexcept {
  SideMask sides = 0;
  for (int side = 0; side < kSides; ++side) sides |= (voxels & kFaces[side]) != 0 ? 1u << side : 0u;
  return sides;
}

VoxelMask voxels_across(VoxelMask voxels, int side) noexcept {
  constexpr int kWidth[] = {3, 12, 48};  // from a face to the opposite one
  const VoxelMask here = voxels & kFaces[side];
  return side % 2 == 0 ? here << kWidth[side / 2] : here >> kWidth[side / 2];
}

}  // namespace tern
