// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The guide's blocks: their parts, what joins them, and the queue that orders them, worked out by hand.
#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "guide/block_map.hpp"
#include "guide/block_parts.hpp"
#include "guide/block_search.hpp"
#include "guide/bucket_queue.hpp"
#include "search/neighbourhood.hpp"
#include "support/path_world.hpp"

namespace {

using tern::BlockMap;
using tern::direction;
using tern::Status;
using tern::Voxel;
using tern_test::VoxelWorld;

constexpr std::uint64_t kWholeBlock = ~std::uint64_t{0};

std::unique_ptr<BlockMap> map_of(const VoxelWorld& world) {
  std::unique_ptr<BlockMap> map(new BlockMap);
  std::memset(static_cast<void*>(map.get()), 0xA5, sizeof *map);
  EXPECT_TRUE(block_map_begin(*map, world.grid));
  return map;
}

tern::BlockMoves all_moves(BlockMap& map, const VoxelWorld& world, const Voxel& block) {
  block_touch(map, world.grid, block);
  return block_moves(map, world.grid, block, tern::kAllSides);
}

tern::CellMask moves_of(BlockMap& map, const VoxelWorld& world, const Voxel& block) {
  return all_moves(map, world, block).moves;
}

TEST(BlockParts, AWallSplitsABlock) {
  VoxelWorld world({8, 8, 8});
  world.block({2, 0, 0}, {2, 3, 3});
  const tern::VoxelMask free = tern::block_voxels(world.grid, {0, 0, 0});
  EXPECT_EQ(free, 0xBBBBBBBBBBBBBBBBu);
  EXPECT_FALSE(tern::one_part(free));
  EXPECT_EQ(tern::connected(1, free), 0x3333333333333333u);
  EXPECT_EQ(tern::sides_touched(0x3333333333333333u), 0b111101u);
  world.clear({2, 3, 3});
  EXPECT_TRUE(tern::one_part(tern::block_voxels(world.grid, {0, 0, 0})));
}

TEST(BlockParts, CornersDoNotConnect) {
  EXPECT_FALSE(tern::one_part(std::uint64_t{1} | std::uint64_t{1} << 5));
  EXPECT_FALSE(tern::one_part(std::uint64_t{1} << 3 | std::uint64_t{1} << 4)) << "the end of a row and the next one";
  EXPECT_TRUE(tern::one_part(kWholeBlock));
  EXPECT_TRUE(tern::one_part(0));
}

TEST(BlockParts, NothingIsFreeOutsideTheGrid) {
  const VoxelWorld world({5, 6, 7});
  EXPECT_EQ(tern::block_voxels(world.grid, {1, 1, 1}), 0x0000001100110011u);
}

TEST(BlockParts, SidesOfAMove) {
  EXPECT_EQ(tern::sides_of(direction(-1, 0, 0)), 0b000001u);
  EXPECT_EQ(tern::sides_of(direction(0, 1, -1)), 0b011000u);
  EXPECT_EQ(tern::opposite(direction(1, -1, 0)), direction(-1, 1, 0));
}

TEST(BlockMap, EmptyBlocksAreJoinedToAllNeighbours) {
  const VoxelWorld world({300, 12, 12});
  const auto map = map_of(world);
  for (const std::int32_t x : {1, 31, 32, 63, 64, 65, 73}) {
    EXPECT_EQ(__builtin_popcount(moves_of(*map, world, {x, 1, 1})), 18) << x;
    EXPECT_TRUE(map->full(map->index({x, 1, 1})));
  }
  EXPECT_EQ(__builtin_popcount(moves_of(*map, world, {0, 0, 0})), 6);
  EXPECT_EQ(__builtin_popcount(moves_of(*map, world, {74, 2, 2})), 6);
}

TEST(BlockMap, FreeVoxelsHaveToMeetAcrossTheFace) {
  VoxelWorld world({8, 4, 4});
  world.block({3, 0, 0}, {3, 3, 3}).clear({3, 1, 1}).block({4, 1, 1});
  EXPECT_EQ(moves_of(*map_of(world), world, {0, 0, 0}), 0u);
  world.clear({3, 2, 1});
  EXPECT_EQ(moves_of(*map_of(world), world, {0, 0, 0}), tern::cell_bit(direction(1, 0, 0)));
}

TEST(BlockMap, ADiagonalNeedsOneCorner) {
  VoxelWorld world({8, 8, 4});
  world.block({4, 0, 0}, {7, 3, 3});
  const tern::CellMask diagonal = tern::cell_bit(direction(1, 1, 0));
  EXPECT_EQ(moves_of(*map_of(world), world, {0, 0, 0}), diagonal | tern::cell_bit(direction(0, 1, 0)));
  world.block({0, 7, 0}, {3, 7, 3});
  EXPECT_EQ(moves_of(*map_of(world), world, {0, 0, 0}) & diagonal, diagonal) << "only its upper side is cut off";
  EXPECT_FALSE(all_moves(*map_of(world), world, {0, 0, 0}).split_beside);
  world.block({2, 4, 0}, {2, 7, 3});
  EXPECT_EQ(moves_of(*map_of(world), world, {0, 0, 0}) & diagonal, 0u) << "the corner is split";
  EXPECT_TRUE(all_moves(*map_of(world), world, {0, 0, 0}).split_beside);
}

TEST(BlockMap, AWideRadiusHasWideBlocks) {
  const VoxelWorld narrow({64, 64, 64}, 1.0, 3.9);
  EXPECT_EQ(map_of(narrow)->dims.x, 16);
  const VoxelWorld wide({64, 64, 64}, 1.0, 4.0);
  const auto map = map_of(wide);
  EXPECT_EQ(map->dims.x, 8);
  EXPECT_EQ(__builtin_popcount(moves_of(*map, wide, {3, 3, 3})), 18);
}

TEST(BucketQueue, LeastBucketFirstThenLastIn) {
  tern::BucketQueue<64, 8> queue;
  std::memset(static_cast<void*>(&queue), 0xA5, sizeof queue);
  queue_reset(queue);
  for (const std::uint32_t bucket : {70u, 68u, 70u, 69u}) EXPECT_TRUE(queue_put(queue, bucket, bucket));
  EXPECT_TRUE(queue_put(queue, 68, 1));
  const std::uint32_t expected[] = {1, 68, 69, 70, 70};
  for (const std::uint32_t item : expected) EXPECT_EQ(queue_take(queue), item);
  EXPECT_EQ(queue.count, 0);
}

TEST(BucketQueue, GoesBackAndTakesEarlyWhatIsFarAhead) {
  tern::BucketQueue<64, 8> queue;
  queue_reset(queue);
  queue_put(queue, 100, 100);
  queue_put(queue, 1000, 1000);
  EXPECT_EQ(queue_take(queue), 100u);
  queue_put(queue, 40, 40);
  EXPECT_EQ(queue_take(queue), 40u);
  EXPECT_EQ(queue_take(queue), 1000u);
  EXPECT_LT(queue.current, 1000u) << "early: whoever takes it puts it in again";
}

TEST(BucketQueue, TellsWhereItIsFull) {
  tern::BucketQueue<64, 3> queue;
  queue_reset(queue);
  for (int round = 0; round < 3; ++round) {
    for (std::uint32_t k = 0; k < 3; ++k) EXPECT_TRUE(queue_put(queue, k, k));
    EXPECT_FALSE(queue_put(queue, 0, 0));
    for (std::uint32_t k = 0; k < 3; ++k) EXPECT_EQ(queue_take(queue), k);
  }
}

TEST(BlockSearch, DistancesCountBlocksAndNarrowOnes) {
  VoxelWorld world({16, 4, 4});
  world.block({5, 0, 0});
  const std::unique_ptr<tern::BlockSearch> search(new tern::BlockSearch);
  ASSERT_TRUE(block_search_begin(*search, world.grid, {0, 0, 0}, {15, 0, 0}));
  while (!search->map.at({3, 0, 0}).closed()) {
    ASSERT_EQ(block_search_take(*search, world.grid), Status::kRunning);
  }
  // Three steps of four voxels; the block with the obstacle costs a fifth more.
  EXPECT_EQ(search->map.at({3, 0, 0}).distance, 3u * 1024u + 204u);
  EXPECT_EQ(search->map.at({3, 0, 0}).arrival(), direction(1, 0, 0));
  EXPECT_EQ(block_search_take(*search, world.grid), Status::kNoPath) << "nothing is left";
}

/// A shell of two voxels in the middle of blocks, which splits each block that it passes.
TEST(BlockSearch, AThinShellHoldsTheGuideAndProvesThatThereIsNoPath) {
  VoxelWorld world({48, 48, 48});
  for (const std::int32_t at : {9, 33}) {
    world.block({at, 9, 9}, {at + 1, 34, 34}).block({9, at, 9}, {34, at + 1, 34}).block({9, 9, at}, {34, 34, at + 1});
  }
  const std::unique_ptr<tern::BlockSearch> search(new tern::BlockSearch);
  ASSERT_TRUE(block_search_begin(*search, world.grid, {20, 20, 20}, {2, 2, 2}));
  Status status = Status::kRunning;
  for (int k = 0; k < 2000 && status == Status::kRunning; ++k) status = block_search_take(*search, world.grid);
  EXPECT_EQ(status, Status::kNoPath);
  EXPECT_FALSE(search->map.at({0, 0, 0}).closed());
  // A hole in the shell, and it gets out.
  world.clear({20, 20, 33}).clear({20, 20, 34});
  ASSERT_TRUE(block_search_begin(*search, world.grid, {20, 20, 20}, {2, 2, 2}));
  status = Status::kRunning;
  while (status == Status::kRunning && !search->map.at({0, 0, 0}).closed()) {
    status = block_search_take(*search, world.grid);
  }
  EXPECT_EQ(status, Status::kRunning);
}

TEST(CellsAfter, OfAStepAlongX) {
  const int right = direction(1, 0, 0);
  EXPECT_EQ(tern::cells_after(tern::cell_bit(direction(1, 1, 0)), right), tern::cell_bit(direction(0, 1, 0)));
  EXPECT_EQ(tern::cells_after(tern::cell_bit(direction(-1, 0, 0)), right), 0u) << "too far away";
  EXPECT_EQ(__builtin_popcount(tern::cells_after(tern::kAllCells, right)), 18);
  EXPECT_EQ(tern::cells_after(tern::kAllCells, tern::kHere), 0u);
}

}  // namespace
