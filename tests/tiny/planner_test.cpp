// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// F09 through the whole planner, in the tiny configuration: each capacity runs out with its own status and its
// high-water mark at the capacity, and the caller's trajectory stays as it was.
#include <gtest/gtest.h>

#include "support/random.hpp"
#include "support/tiny_cases.hpp"
#include "support/world.hpp"

namespace {

using tern::Stage;
using tern::Status;
using tern_test::Random;
using tern_test::slalom;
using tern_test::World;

/// Single voxels strewn at random: many jump points.
World noise(double density, std::uint64_t seed) {
  World world({32, 32, 16}, 0.25, 0.0);
  Random random(seed);
  for (int z = 0; z < 16; ++z) {
    for (int y = 0; y < 32; ++y) {
      for (int x = 0; x < 32; ++x) {
        const bool ends = x + y + z <= 2 || x + y + z >= 75;
        if (!ends && random.chance(density)) world.grid.mark_voxel({x, y, z});
      }
    }
  }
  world.from({0.125, 0.125, 0.125}).to({7.875, 7.875, 3.875});
  return world;
}

/// A goal that is walled in, beside the start: the search wanders off until it is out of room, the flood does not.
TEST(TinyPlanner, AsNearAsPossibleNeedsNoNodesToFindOutThatThereIsNoPath) {
  int missed = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    World world = noise(0.1, seed);
    world.block({2.0, 2.0, 1.0}, {3.75, 3.75, 2.75}).grid.clear_box({{2.25, 2.75, 1.75}, {2.5, 3.0, 2.0}});
    world.grid.clear_box({{1.0, 2.5, 1.5}, {2.0, 3.0, 2.0}});
    world.from({1.125, 2.875, 1.875}).to({2.375, 2.875, 1.875});
    world.request.search = tern::SearchMode::kOptimal;
    const Status exact = world.plan();
    if (exact != Status::kNodesFull && exact != Status::kOpenFull) continue;
    EXPECT_TRUE(world.report.has_reachable);
    EXPECT_NEAR(world.report.reachable.x, 1.875, 1e-12);
    world.request.goal_mode = tern::GoalMode::kNearest;
    ASSERT_EQ(world.replan(), Status::kOk);
    EXPECT_EQ(world.report.goal_missed, exact);
    ++missed;
  }
  EXPECT_GT(missed, 10);
}

/// A goal that can be reached, with more room than there is.
TEST(TinyPlanner, AsNearAsPossibleSaysWhatWasFullWhereThereIsAPath) {
  int full = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    World world = noise(0.1, seed);
    world.request.goal_mode = tern::GoalMode::kNearest;
    world.request.search = tern::SearchMode::kOptimal;
    const Status status = world.plan();
    if (status != Status::kNodesFull && status != Status::kOpenFull) continue;
    EXPECT_TRUE(world.report.has_reachable);
    EXPECT_EQ(world.report.goal_missed, Status::kOk);
    ++full;
  }
  EXPECT_GT(full, 10);
}

TEST(TinyPlanner, OpenSpaceFits) {
  World world({32, 32, 16}, 0.25, 0.3);
  world.from({0.5, 0.5, 0.5}).to({2.0, 1.5, 1.0});
  EXPECT_EQ(world.plan(), Status::kOk);
}

/// The capacities that random worlds run into, each with its mark.
TEST(TinyPlanner, EachOverflowHasItsStatusAndMark) {
  int nodes = 0;
  int open = 0;
  int jump_points = 0;
  int segments = 0;
  int planes = 0;
  int boxes = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    World world = seed % 2 == 0 ? noise(0.02 * static_cast<double>(1 + seed % 14), seed)
                                : slalom(static_cast<int>(1 + seed % 12));
    const Status status = world.plan();
    const tern::HighWater& high = world.report.diagnostics.high_water;
    EXPECT_LE(high.nodes, tern::kMaxNodes);
    EXPECT_LE(high.open, tern::kMaxOpen);
    EXPECT_LE(high.segments, tern::kMaxSegments);
    if (status == Status::kNodesFull && ++nodes > 0) {
      EXPECT_EQ(high.nodes, tern::kMaxNodes);
    }
    if (status == Status::kOpenFull && ++open > 0) {
      EXPECT_EQ(high.open, tern::kMaxOpen);
    }
    if (status == Status::kJumpPointsFull && ++jump_points > 0) {
      EXPECT_EQ(high.jump_points, tern::kMaxJumpPoints);
    }
    if (status == Status::kSegmentsFull && ++segments > 0) {
      EXPECT_EQ(high.segments, tern::kMaxSegments);
    }
    if (status == Status::kPlanesFull && ++planes > 0) {
      EXPECT_EQ(high.planes, tern::kMaxPlanes);
    }
    if (status == Status::kObstaclesFull && ++boxes > 0) {
      EXPECT_EQ(high.local_boxes, tern::kMaxLocalBoxes);
    }
    if (status != Status::kOk) {
      EXPECT_TRUE(world.trajectory_untouched());
    }
  }
  EXPECT_GT(nodes, 0);
  EXPECT_GT(open, 0);
  EXPECT_GT(segments, 0);
}

/// Voxels strewn at random, and two free ones near each other.
World strewn(Random& random) {
  World world({32, 32, 16}, 0.25, 0.0);
  const auto any = [&random] {
    return tern::Voxel{random.integer(0, 31), random.integer(0, 31), random.integer(0, 15)};
  };
  for (int k = random.integer(3000, 5000); k > 0; --k) world.grid.mark_voxel(any());
  const tern::Voxel start = any();
  const tern::Voxel goal{(start.x + random.integer(0, 9)) % 32, (start.y + random.integer(0, 9)) % 32,
                         (start.z + random.integer(0, 4)) % 16};
  world.grid.clear_voxel(start);
  world.grid.clear_voxel(goal);
  const auto centre = [](const tern::Voxel& v) {
    return tern::Vec3{0.25 * v.x + 0.125, 0.25 * v.y + 0.125, 0.25 * v.z + 0.125};
  };
  world.from(centre(start)).to(centre(goal));
  return world;
}

/// A fast path that needs too many segments is never the last word: the optimal search has its say.
TEST(TinyPlanner, AFastPathThatDoesNotFitIsSearchedForAgain) {
  Random random(31);
  int again = 0;
  for (int k = 0; k < 1500; ++k) {
    World world = strewn(random);
    world.request.search = tern::SearchMode::kFast;
    const Status status = world.plan();
    const tern::StageReport& search = world.report.diagnostics.stages[static_cast<int>(Stage::kSearch)];
    const tern::StageReport& shortcut = world.report.diagnostics.stages[static_cast<int>(Stage::kShortcut)];
    EXPECT_LE(search.work, search.bound);
    EXPECT_LE(shortcut.work, shortcut.bound);
    if (status == Status::kSegmentsFull) {
      EXPECT_EQ(world.report.diagnostics.search_used, tern::SearchUsed::kOptimal) << "case " << k;
    }
    // A plan that fails in the search although a path was shortened before.
    again += world.report.stage == Stage::kSearch && shortcut.work > 0 ? 1 : 0;
  }
  EXPECT_GT(again, 0);
}

}  // namespace
