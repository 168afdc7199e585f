// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "guide/block_search.hpp"

namespace tern {
namespace {

constexpr int kBucketBits = 8;
static_assert(kGuideStraight == 1 << kBucketBits, "a bucket a voxel");

/// Cost of a step into a block that is not wholly free: a fifth more. In open space, the search of voxels takes fewer
/// expansions.
constexpr GuideCost narrow(GuideCost cost) {
  return cost + cost / 5;
}

/// The costliest step in blocks of eight voxels, plus the same again, by which the heuristic may grow.
static_assert((8 * (narrow(kGuidePlane) + kGuidePlane) >> kBucketBits) + 1 < kBlockBuckets, "f stays within the ring");
static_assert(std::uint64_t{kGuideBlocks} * 4 * narrow(kGuidePlane) < kFar - 8 * 2048 * kGuideSpace,
              "a path visits a block once");

/// Costs of a step into a block that is wholly free, for blocks four and eight voxels wide.
struct BlockCosts {
  GuideCost of[2][kDirections];
};
constexpr BlockCosts make_costs() {
  BlockCosts costs{};
  for (int move = 0; move < kDirections; ++move) {
    costs.of[0][move] = guide_cost(move) << 2;
    costs.of[1][move] = guide_cost(move) << 3;
  }
  return costs;
}
constexpr BlockCosts kBlockCosts = make_costs();

/// A block's coordinates as one number.
constexpr std::uint32_t pack(const Voxel& block) {
  return static_cast<std::uint32_t>(block.x | block.y << 10 | block.z << 20);
}
constexpr Voxel unpack(std::uint32_t packed) {
  return {static_cast<std::int32_t>(packed & 1023u), static_cast<std::int32_t>(packed >> 10 & 1023u),
          static_cast<std::int32_t>(packed >> 20)};
}
static_assert(kMaxDimension / 4 <= 1024, "ten bits a coordinate");

bool open_block(BlockSearch& search, const Voxel& block, GuideCost distance) {
  const GuideCost left = guide_octile(block, search.target) << search.map.log;
  return queue_put(search.open, (distance + left) >> kBucketBits, pack(block));
}

/// The sides across which the best path may have entered a block. For a move around a corner, these are the sides that
/// a block at the corner joins to the block before.
SideMask entrances(BlockSearch& search, const Grid& grid, const Voxel& at, int arrival) {
  if (axes_of(arrival) == 1) return sides_of(opposite(arrival));
  BlockMap& map = search.map;
  const Voxel from = at + offset(opposite(arrival));
  SideMask sides = 0;
  for (SideMask left = sides_of(arrival); left != 0; left &= left - 1) {
    const SideMask first = left & (~left + 1);
    const Voxel corner = from + offset(kSideMove[__builtin_ctz(left)]);
    const SideMask second = sides_of(arrival) & ~first;
    const bool joined = (map.at(from).sides & first) != 0 && (map.at(corner).sides & second) != 0 &&
                        !block_split(map, grid, corner, map.at(corner));
    if (joined) sides |= sides_of(opposite(kSideMove[__builtin_ctz(second)]));
  }
  return sides;
}

/// The sides across which the search may leave a block. If the block is split, these are the sides of the part that it
/// arrived in.
SideMask exits(BlockSearch& search, const Grid& grid, const Voxel& at) {
  BlockMap& map = search.map;
  if (!block_split(map, grid, at, map.at(at))) return kAllSides;
  search.lost = true;
  const int arrival = map.at(at).parent;
  const VoxelMask entered = arrival == kHere ? VoxelMask{1} << place_in_block(search.origin)
                                             : voxels_at(entrances(search, grid, at, arrival));
  return sides_touched(connected(entered, block_voxels(grid, at)));
}

}  // namespace

bool block_search_begin(BlockSearch& search, const Grid& grid, const Voxel& from, const Voxel& towards) noexcept {
  if (!block_map_begin(search.map, grid)) return false;
  search.target = search.map.block_of(towards);
  search.origin = from;
  search.lost = false;
  search.f = 0;
  queue_reset(search.open);
  const Voxel origin = search.map.block_of(from);
  block_touch(search.map, grid, origin);
  block_touch(search.map, grid, search.target);
  search.map.at(origin).distance = 0;
  return open_block(search, origin, 0);
}

Status block_search_take(BlockSearch& search, const Grid& grid) noexcept {
  BlockMap& map = search.map;
  if (search.open.count == 0) return search.lost ? Status::kNodesFull : Status::kNoPath;
  const Voxel at = unpack(queue_take(search.open));
  Block& block = map.at(at);
  if (block.closed()) return Status::kRunning;
  block.flags |= Block::kClosed;
  search.f = search.open.current << kBucketBits;
  const GuideCost* const costs = kBlockCosts.of[map.log - 2];
  const GuideCost here = block.distance;
  const CellMask moves = block_moves(map, grid, at, exits(search, grid, at));
  for (CellMask left = moves; left != 0; left &= left - 1) {
    const int move = __builtin_ctz(left);
    Block& next = (&block)[map.offsets[move]];
    const GuideCost cost = costs[move];
    if (next.distance <= here + cost || next.closed()) continue;
    const GuideCost distance = here + (next.full() ? cost : narrow(cost));
    if (next.distance <= distance) continue;
    next.distance = distance;
    next.parent = static_cast<std::uint8_t>(move);
    if (!open_block(search, at + kMoveOf.at[move].step, distance)) return Status::kOpenFull;
  }
  return Status::kRunning;
}

}  // namespace tern
