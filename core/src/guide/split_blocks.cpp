// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "guide/split_blocks.hpp"

namespace tern {
namespace {

Voxel beside(const Voxel& block, int side) {
  return block + offset(kSideMove[side]);
}

/// The side opposite to a side: sides 0 and 1, 2 and 3, and 4 and 5 are pairs.
constexpr int across(int side) {
  return side ^ 1;
}

int first_side(SideMask sides) {
  return __builtin_ctz(sides);
}

/// The voxels of a block at which the best path may have entered it. After a move around a corner, it may have come
/// from any block at the corner that joins the two blocks and is not split.
VoxelMask entered(BlockMap& map, const Grid& grid, const Voxel& block, int arrival) {
  const Voxel from = block + offset(opposite(arrival));
  if (axes_of(arrival) == 1) return voxels_across(part_of(map, grid, from), first_side(sides_of(arrival)));
  VoxelMask voxels = 0;
  for (SideMask left = sides_of(arrival); left != 0; left &= left - 1) {
    const SideMask first = left & (~left + 1);
    const SideMask second = sides_of(arrival) & ~first;
    const Voxel corner = beside(from, first_side(first));
    const bool joined =
        (map.joined(from) & first) != 0 && (map.joined(corner) & second) != 0 && !block_split(map, grid, corner);
    if (joined) voxels |= voxels_across(block_voxels(grid, corner), first_side(second));
  }
  return voxels;
}

}  // namespace

VoxelMask part_of(BlockMap& map, const Grid& grid, const Voxel& block) noexcept {
  const VoxelMask free = block_voxels(grid, block);
  if (!block_split(map, grid, block)) return free;
  return connected(VoxelMask{1} << map.entries[map.index(block)], free);
}

SideMask enter_part(BlockMap& map, const Grid& grid, const Voxel& block, int place) noexcept {
  const int arrival = map.at(block).arrival();
  const VoxelMask free = block_voxels(grid, block);
  const VoxelMask at = arrival == kHere ? VoxelMask{1} << place : entered(map, grid, block, arrival) & free;
  // The set cannot be empty: the guide leaves a part only across sides at which the part meets the next block.
  const int entry = at != 0 ? __builtin_ctzll(at) : place;
  map.entries[map.index(block)] = static_cast<std::uint8_t>(entry);
  const VoxelMask part = connected(VoxelMask{1} << entry, free);
  SideMask sides = 0;
  for (SideMask left = map.joined(block); left != 0; left &= left - 1) {
    const int side = first_side(left);
    const bool meets = (voxels_across(part, side) & block_voxels(grid, beside(block, side))) != 0;
    sides |= meets ? 1u << side : 0u;
  }
  return sides;
}

bool leaves_out(BlockMap& map, const Grid& grid, const Voxel& block) noexcept {
  const bool split = block_split(map, grid, block);
  const VoxelMask free = block_voxels(grid, block);
  const VoxelMask part = part_of(map, grid, block);
  for (SideMask left = map.joined(block); left != 0; left &= left - 1) {
    const int side = first_side(left);
    const Voxel next = beside(block, side);
    if (!map.at(next).closed() || !(split || block_split(map, grid, next))) continue;
    const VoxelMask next_part = part_of(map, grid, next);
    const VoxelMask ahead = voxels_across(part, side) & block_voxels(grid, next) & ~next_part;
    const VoxelMask behind = voxels_across(next_part, across(side)) & free & ~part;
    if ((ahead | behind) != 0) return true;
  }
  return false;
}

}  // namespace tern
