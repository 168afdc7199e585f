// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// F09 for the guided search: each of its capacities runs out in a build where that is cheap. None is the plan's
// business: the optimal search answers then.
#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "guide/voxel_search.hpp"
#include "support/path_world.hpp"
#include "support/reference_search.hpp"

namespace {

using tern::Status;
using tern::Voxel;
using tern_test::PathQuery;
using tern_test::PathRunner;
using tern_test::Random;
using tern_test::random_ends;
using tern_test::random_free;
using tern_test::VoxelWorld;

VoxelWorld strewn_world(Random& random) {
  VoxelWorld world({32, 32, 16});
  const int blocks = random.integer(0, 3000);
  for (int k = 0; k < blocks; ++k) {
    world.grid.mark_voxel({random.integer(0, 31), random.integer(0, 31), random.integer(0, 15)});
  }
  world.grid.inflate();
  return world;
}

TEST(TinyGuide, EveryCapacityRunsOut) {
  const std::unique_ptr<tern::GuidedSearch> search(new tern::GuidedSearch);
  std::memset(static_cast<void*>(search.get()), 0xA5, sizeof *search);
  Random random(71);
  int voxels = 0;
  int pages = 0;
  int open = 0;
  int blocks = 0;
  for (int k = 0; k < 6000; ++k) {
    const VoxelWorld world = strewn_world(random);
    Voxel start{};
    Voxel goal{};
    if (!random_ends(world.grid, random, start, goal)) continue;
    ASSERT_TRUE(guided_begin(*search, world.grid, start, goal));
    tern::Work work{0xFFFFFFFFu};
    const Status status = guided_advance(*search, world.grid, work);
    ASSERT_LE(search->entries, tern::kGuidedBound);
    ASSERT_LE(search->store.count, tern::kGuidePages);
    ASSERT_LE(search->open.count, tern::kGuidedOpen);
    ASSERT_LE(search->guide.open.count, tern::kBlockOpen);
    const bool nodes_full = status == Status::kNodesFull;
    voxels += nodes_full && search->expanded > tern::kGuidedExpansions ? 1 : 0;
    pages += nodes_full && search->store.count == tern::kGuidePages ? 1 : 0;
    open += status == Status::kOpenFull && search->open.count == tern::kGuidedOpen ? 1 : 0;
    blocks += status == Status::kOpenFull && search->guide.open.count == tern::kBlockOpen ? 1 : 0;
  }
  EXPECT_GT(voxels, 0);
  EXPECT_GT(pages, 0);
  EXPECT_GT(open, 0);
  EXPECT_GT(blocks, 0);
}

TEST(TinyGuide, TheOptimalSearchAnswersThen) {
  tern_test::PathRunner runner;
  Random random(72);
  int fallen_back = 0;
  for (int k = 0; k < 600; ++k) {
    const VoxelWorld world = strewn_world(random);
    Voxel start{};
    if (!random_free(world.grid, random, start)) continue;
    const Voxel goal{(start.x + random.integer(0, 6)) % 32, (start.y + random.integer(0, 6)) % 32, start.z};
    if (!world.grid.free(goal)) continue;
    tern_test::PathQuery query{world.grid.center(start), world.grid.center(goal)};
    const Status optimal = runner.run(world.grid, query);
    query.search = tern::SearchMode::kFast;
    const Status fast = runner.run(world.grid, query);
    if (optimal == Status::kOk || optimal == Status::kNoPath) {
      ASSERT_TRUE(fast == optimal || fast == Status::kSegmentsFull) << "case " << k;
    }
    fallen_back += runner.search().search_used == tern::SearchUsed::kOptimal ? 1 : 0;
  }
  EXPECT_GT(fallen_back, 0);
}

/// What fast searches in worlds of thick obstacles end with, against optimal ones.
struct ThickWorlds {
  PathRunner runner;
  int flooded = 0;  ///< after floods around both ends
  int guided = 0;   ///< the same, with a path that the guided search found

  void run(const Voxel& dims, Random& random) {
    VoxelWorld world(dims, 1.0, 4.0);
    for (int k = random.integer(0, 6); k > 0; --k) {
      const Voxel at = random_voxel(random, dims);
      const Voxel size{random.integer(0, 19), random.integer(0, 19), random.integer(0, 19)};
      world.grid.mark_box({world.grid.center(at), world.grid.center(at + size)});
    }
    world.grid.inflate();
    Voxel start{};
    Voxel goal{};
    if (!random_ends(world.grid, random, start, goal)) return;
    PathQuery query{world.grid.center(start), world.grid.center(goal)};
    const Status exact = runner.run(world.grid, query);
    query.search = tern::SearchMode::kFast;
    const Status fast = runner.run(world.grid, query);
    if (exact == Status::kOk || exact == Status::kNoPath) {
      ASSERT_TRUE(fast == exact || fast == Status::kSegmentsFull);
    }
    const tern::VoxelSearch& search = runner.search().search;
    if (!search.start_flooded || !search.goal_flooded) return;
    ++flooded;
    EXPECT_FALSE(search.guided.guide.map.large()) << "the last guide";
    guided += runner.search().search_used == tern::SearchUsed::kGuided ? 1 : 0;
  }
};

TEST(TinyGuide, SmallBlocksFollowLargeOnes) {
  ThickWorlds worlds;
  Random random(73);
  for (int k = 0; k < 400 && !HasFatalFailure(); ++k) worlds.run({32, 32, 32}, random);
  EXPECT_GT(worlds.flooded, 0);
}

/// 16 x 15 x 3 small blocks are more than the guide holds here, and 8 x 8 x 2 large ones are not.
TEST(TinyGuide, WithoutRoomForSmallBlocksTheOptimalSearchFollows) {
  ThickWorlds worlds;
  Random random(74);
  for (int k = 0; k < 400 && !HasFatalFailure(); ++k) worlds.run({9, 61, 57}, random);
  EXPECT_GT(worlds.flooded, 0);
  EXPECT_EQ(worlds.guided, 0);
}

/// Small blocks alone are for thin obstacles, and here there is no room for them.
TEST(TinyGuide, WithoutRoomForAGuideTheOptimalSearchGoesOn) {
  PathRunner runner;
  Random random(75);
  int begun = 0;
  for (int k = 0; k < 300; ++k) {
    VoxelWorld world({9, 61, 57});
    for (int m = 0; m < 6000; ++m) world.grid.mark_voxel(random_voxel(random, world.grid.spec().dims));
    world.grid.inflate();
    Voxel start{};
    if (!random_free(world.grid, random, start)) continue;
    const Voxel goal{random.integer(0, 8), (start.y + random.integer(0, 8)) % 61,
                     (start.z + random.integer(0, 8)) % 57};
    PathQuery query{world.grid.center(start), world.grid.center(goal)};
    const Status exact = runner.run(world.grid, query);
    const std::uint32_t expansions = runner.search().pieces;
    query.search = tern::SearchMode::kFast;
    ASSERT_EQ(runner.run(world.grid, query), exact) << "case " << k;
    ASSERT_NE(runner.search().search_used, tern::SearchUsed::kGuided);
    begun += runner.search().pieces > expansions ? 1 : 0;
  }
  EXPECT_GT(begun, 0) << "the first of the two searches that follow each other";
}

}  // namespace
