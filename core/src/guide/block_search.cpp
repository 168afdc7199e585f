// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "guide/block_search.hpp"

#include "base/capacity.hpp"
#include "search/neighbourhood.hpp"
#include "search/node_store.hpp"

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

/// The voxels that the guide may have reached in a block: all free ones or, in a split block, the part that it entered.
/// A split block must be closed.
VoxelMask part_of(BlockMap& map, const Grid& grid, const Voxel& block) {
  const VoxelMask free = block_voxels(grid, block);
  if (!block_split(map, grid, block)) return free;
  return connected(VoxelMask{1} << map.entries[map.index(block)], free);
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

/// Enters a split block that is about to be closed: by its arrival or, if it has none, in its voxel at `place`. Returns
/// the sides across which the entered part meets a neighbour.
SideMask enter_part(BlockMap& map, const Grid& grid, const Voxel& block, int place) {
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

/// True if the guide has left out a part that it could have reached, of this closed block or of a closed neighbour.
/// In that case, the part that it entered in one of the two blocks touches a part of the other that it did not enter.
bool leaves_out(BlockMap& map, const Grid& grid, const Voxel& block) {
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

constexpr int kBucketBits = 8;
static_assert(kGuideStraight == 1 << kBucketBits, "a bucket a voxel");

/// Cost of a step into a block that is not wholly free: a fifth more. In open space, the search of voxels takes fewer
/// expansions.
constexpr GuideCost narrow(GuideCost cost) {
  return cost + cost / 5;
}

/// The ring must hold the costliest step in blocks of eight voxels, and the most by which the heuristic may grow in
/// that step.
static_assert((8 * (narrow(kGuidePlane) + kGuidePlane) >> kBucketBits) + 1 < kBlockBuckets, "f stays within the ring");
static_assert(std::uint64_t{kGuideBlocks} * 4 * narrow(kGuidePlane) < kFar - 8 * 2048 * kGuideSpace,
              "a path visits a block once");

/// Costs of a step into a block, for blocks four and eight voxels wide.
struct BlockCosts {
  struct Step {
    GuideCost into[2];  ///< cost of a step into a block that is not wholly free, and into a full one
  };
  Step of[2][kDirections];
};
constexpr BlockCosts make_costs() {
  BlockCosts costs{};
  for (int large = 0; large < 2; ++large) {
    for (int move = 0; move < kDirections; ++move) {
      const GuideCost cost = guide_cost(move) << (2 + large);
      costs.of[large][move] = {{narrow(cost), cost}};
    }
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

/// The step of a block's packed coordinates for each move.
struct PackedMoves {
  std::uint32_t by[kDirections];
};
constexpr PackedMoves make_packed_moves() {
  PackedMoves moves{};
  for (int move = 0; move < kDirections; ++move) {
    const Voxel step = offset(move);
    moves.by[move] = static_cast<std::uint32_t>(step.x + step.y * 1024 + step.z * 1024 * 1024);
  }
  return moves;
}
constexpr PackedMoves kPackedMoves = make_packed_moves();

/// The bucket of a block with a path of this cost.
std::uint32_t bucket_of(const BlockSearch& search, const Voxel& block, GuideCost distance) {
  return (distance + (guide_octile(block, search.target) << search.map.log)) >> kBucketBits;
}

/// Closes a block. Returns the moves from it.
CellMask close(BlockSearch& search, const Grid& grid, const Voxel& at, Block& block) {
  BlockMap& map = search.map;
  const bool split = block_split(map, grid, at);
  const SideMask sides = split ? enter_part(map, grid, at, place_in_page(search.origin)) : kAllSides;
  const BlockMoves from = block_moves(map, grid, at, sides);
  block.link |= from.moves | kBlockClosed;
  if (split || from.split_beside) search.lost = search.lost || leaves_out(map, grid, at);
  return from.moves;
}

}  // namespace

bool block_search_begin(BlockSearch& search, const Grid& grid, const Voxel& from, const Voxel& towards,
                        bool small) noexcept {
  if (!block_map_begin(search.map, grid, small)) return false;
  search.target = search.map.block_of(towards);
  search.origin = from;
  search.lost = false;
  search.f = 0;
  queue_reset(search.open);
  const Voxel origin = search.map.block_of(from);
  block_touch(search.map, grid, origin);
  block_touch(search.map, grid, search.target);
  search.map.at(origin).distance = 0;
  return queue_put(search.open, bucket_of(search, origin, 0), pack(origin));
}

Status block_search_take(BlockSearch& search, const Grid& grid) noexcept {
  BlockMap& map = search.map;
  if (search.open.count == 0) return search.lost ? Status::kNodesFull : Status::kNoPath;
  const std::uint32_t packed = queue_take(search.open);
  const Voxel at = unpack(packed);
  const std::int32_t index = map.index(at);
  Block& block = map.blocks[index];
  if (block.closed()) return Status::kRunning;
  search.f = search.open.current << kBucketBits;
  const int arrival = block.arrival();
  const CellMask moves = close(search, grid, at, block);
  const CellMask known = cells_after(map.blocks[index - map.offsets[arrival]].moves(), arrival);
  const BlockCosts::Step* const costs = kBlockCosts.of[map.log - 2];
  const GuideCost here = block.distance;
  // First finds the moves that may give better paths than the known ones, without branches, which would be hard to
  // predict.
  CellMask better = 0;
  for (CellMask left = moves & ~known; left != 0; left &= left - 1) {
    const int move = __builtin_ctz(left);
    const bool improves = here + costs[move].into[1] < (&block)[map.offsets[move]].distance;
    better |= static_cast<CellMask>(improves) << move;
  }
  for (; better != 0; better &= better - 1) {
    const int move = __builtin_ctz(better);
    const std::int32_t to = index + map.offsets[move];
    const GuideCost distance = here + costs[move].into[map.full(to)];
    if (map.blocks[to].distance <= distance || map.blocks[to].closed()) continue;
    map.blocks[to] = {distance, arrival_link(move)};
    const Voxel end = at + kMoveOf.at[move].step;
    const bool room = queue_put(search.open, bucket_of(search, end, distance), packed + kPackedMoves.by[move]);
    if (is_full(!room)) return Status::kOpenFull;
  }
  return Status::kRunning;
}

}  // namespace tern
