// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// F09 for the search and shortcut stages: every capacity runs out in a build where that is cheap, says its own name,
// and its high-water mark is the capacity.
#include <gtest/gtest.h>

#include "support/path_world.hpp"
#include "support/reference_search.hpp"

namespace {

using tern::Status;
using tern::Voxel;
using tern_test::PathQuery;
using tern_test::PathRunner;
using tern_test::Random;
using tern_test::VoxelWorld;

/// A flat map with `walls` walls across it, open at alternating ends: the only way winds around each.
VoxelWorld serpentine(int walls) {
  VoxelWorld world({4 * walls + 3, 12, 1});
  for (int k = 0; k < walls; ++k) {
    const int x = 4 * k + 3;
    const int gap = k % 2 == 0 ? 11 : 0;
    world.block({x, 0, 0}, {x, 11, 0}).clear({x, gap, 0});
  }
  return world;
}

Status run_serpentine(PathRunner& runner, int walls) {
  const VoxelWorld world = serpentine(walls);
  return runner.run(world.grid, Voxel{0, 0, 0}, Voxel{4 * walls + 2, 0, 0});
}

TEST(TinySearch, SegmentsThenWaypointsRunOut) {
  PathRunner runner;
  ASSERT_EQ(run_serpentine(runner, 1), Status::kOk);
  EXPECT_EQ(runner.shortcut().segments_high, runner.path().count - 1);
  int segments_full = 0;
  int jump_points_full = 0;
  for (int walls = 2; walls <= 8; ++walls) {
    const Status status = run_serpentine(runner, walls);
    if (status == Status::kSegmentsFull) {
      EXPECT_EQ(runner.shortcut().segments_high, tern::kMaxSegments);
      EXPECT_EQ(runner.last(), tern::Stage::kShortcut);
      EXPECT_GT(runner.path().count, tern::kMaxWaypoints);
      EXPECT_LE(runner.path().raw_count, tern::kMaxJumpPoints);
      EXPECT_EQ(jump_points_full, 0) << "longer mazes need more points";
      ++segments_full;
    }
    if (status == Status::kJumpPointsFull) {
      EXPECT_EQ(runner.search().raw_high, tern::kMaxJumpPoints);
      EXPECT_EQ(runner.last(), tern::Stage::kSearch);
      ++jump_points_full;
    }
    if (status == Status::kOk) {
      EXPECT_LE(runner.path().count, tern::kMaxWaypoints);
    }
  }
  EXPECT_GT(segments_full, 0);
  EXPECT_GT(jump_points_full, 0);
}

TEST(TinySearch, NodesRunOut) {
  PathRunner runner;
  Random random(61);
  int full = 0;
  for (int k = 0; k < 200; ++k) {
    VoxelWorld world({30, 30, 1});
    for (int m = 0; m < 250; ++m) world.grid.mark_voxel({random.integer(0, 29), random.integer(0, 29), 0});
    world.grid.clear_voxel({0, 0, 0});
    world.grid.clear_voxel({29, 29, 0});
    world.grid.inflate();
    const Status status = runner.run(world.grid, Voxel{0, 0, 0}, Voxel{29, 29, 0});
    EXPECT_LE(runner.search().nodes_high, tern::kMaxNodes);
    EXPECT_LE(runner.search().open_high, tern::kMaxOpen);
    if (status != Status::kNodesFull) continue;
    EXPECT_EQ(runner.search().nodes_high, tern::kMaxNodes);
    EXPECT_EQ(runner.last(), tern::Stage::kSearch);
    ++full;
  }
  EXPECT_GT(full, 0);
}

TEST(TinySearch, HeapRunsOut) {
  PathRunner runner;
  Random random(62);
  int full = 0;
  for (int k = 0; k < 50; ++k) {
    VoxelWorld world({24, 24, 24});
    for (int m = 0; m < 300; ++m) {
      world.grid.mark_voxel({random.integer(2, 21), random.integer(2, 21), random.integer(2, 21)});
    }
    world.grid.inflate();
    const Status status = runner.run(world.grid, Voxel{0, 0, 0}, Voxel{23, 23, 23});
    if (status != Status::kOpenFull) continue;
    EXPECT_EQ(runner.search().open_high, tern::kMaxOpen);
    EXPECT_LE(runner.search().nodes_high, tern::kMaxNodes);
    ++full;
  }
  EXPECT_GT(full, 0);
}

// 24 x 24 lines of one word each are more than a layer of stops holds here: scans go step by step.
TEST(TinySearch, ScansWithoutStopsFindTheSameCost) {
  static_assert(24 * 24 > tern::kJumpStopWords, "the map must not fit");
  PathRunner runner;
  Random random(64);
  int solved = 0;
  for (int k = 0; k < 500; ++k) {
    VoxelWorld world({24, 24, 24});
    for (int m = 0; m < 300; ++m) {
      world.grid.mark_voxel({random.integer(0, 23), random.integer(0, 23), random.integer(0, 23)});
    }
    world.grid.inflate();
    const Voxel start{random.integer(0, 23), random.integer(0, 23), random.integer(0, 23)};
    // Near enough for the tiny capacities.
    const Voxel goal{(start.x + random.integer(0, 6)) % 24, (start.y + random.integer(0, 6)) % 24,
                     (start.z + random.integer(0, 6)) % 24};
    if (runner.run(world.grid, start, goal) != Status::kOk) continue;
    ASSERT_NEAR(runner.path().grid_length, tern_test::ReferenceSearch(world.grid).cost(start, goal), 1e-9);
    ++solved;
  }
  EXPECT_GT(solved, 50);
}

// 3 x 16 x 15 blocks of 4 x 4 x 4 are more than there are records of: what is beyond them is dominated by nothing.
TEST(TinySearch, BlocksWithoutARecordAreSearchedAtTheSameCost) {
  static_assert(3 * 16 * 15 > tern::kDominancePages, "the map must not fit");
  PathRunner runner;
  Random random(65);
  int solved = 0;
  for (int k = 0; k < 300; ++k) {
    VoxelWorld world({9, 61, 57});
    for (int m = 0; m < 4000; ++m) world.grid.mark_voxel(random_voxel(random, world.grid.spec().dims));
    world.grid.inflate();
    // The blocks are counted along x, then y, then z.
    const Voxel start{random.integer(0, 8), random.integer(0, 54), random.integer(44, 56)};
    const Voxel goal{random.integer(0, 8), start.y + random.integer(0, 6), random.integer(44, 56)};
    if (runner.run(world.grid, start, goal) != Status::kOk) continue;
    ASSERT_NEAR(runner.path().grid_length, tern_test::ReferenceSearch(world.grid).cost(start, goal), 1e-9);
    ++solved;
  }
  EXPECT_GT(solved, 30);
}

TEST(TinySearch, OverflowIsTheSameInEverySlice) {
  PathRunner whole;
  PathRunner sliced;
  Random random(63);
  for (int k = 0; k < 60; ++k) {
    VoxelWorld world({20, 20, 6});
    for (int m = 0; m < 400; ++m) {
      world.grid.mark_voxel({random.integer(1, 18), random.integer(1, 18), random.integer(0, 5)});
    }
    world.grid.inflate();
    const PathQuery query{world.grid.center({0, 0, 0}), world.grid.center({19, 19, 5})};
    const Status status = whole.run(world.grid, query);
    ASSERT_EQ(sliced.run(world.grid, query, 1), status);
    ASSERT_EQ(sliced.search().pieces, whole.search().pieces);
    ASSERT_EQ(sliced.search().nodes_high, whole.search().nodes_high);
  }
}

}  // namespace
