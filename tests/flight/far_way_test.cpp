// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A far way against a plain A* on its coarse grid, what it does where the rolling map shows more, and its refusals.
#include "tern/far_way.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "support/far_world.hpp"
#include "support/random.hpp"
#include "support/reference_search.hpp"

namespace {

using tern::FarState;
using tern::FarWay;
using tern::Status;
using tern::Vec3;
using tern::Voxel;
using tern_test::build_blocks;
using tern_test::build_streets;
using tern_test::FarWorld;
using tern_test::kCoarse;
using tern_test::kMuch;
using tern_test::Random;
using tern_test::random_free;

TEST(FarWay, FindsWhatAPlainSearchFinds) {
  Random random(1);
  int none = 0;
  double excess = 0.0;
  for (int k = 0; k < tern_test::scaled(400); ++k) {
    FarWorld world({24, 20, 6});
    build_blocks(random, world);
    const Voxel start = random_free(world.coarse.grid, random);
    const Voxel goal = random_free(world.coarse.grid, random);
    const double least = kCoarse * tern_test::ReferenceSearch(world.coarse.grid).cost(start, goal);
    world.begin(world.centre(goal));
    world.find_way(world.centre(start));
    if (least < 0.0) {
      // It leads as near to the goal as a way leads, and from there to the goal.
      ++none;
      ASSERT_EQ(world.far.state(), FarState::kLeads);
      continue;
    }
    ASSERT_EQ(world.far.state(), FarState::kLeads) << k;
    ASSERT_GE(world.far.left(), least - 1e-9) << k;
    ASSERT_LE(world.far.left(), 1.5 * least + 1e-9) << k;
    excess += least > 0.0 ? world.far.left() / least - 1.0 : 0.0;
  }
  EXPECT_GT(none, 0);
  EXPECT_LT(excess / tern_test::scaled(400), 0.03);
}

TEST(FarWay, NearGoalsLieInFreeCellsOneAfterTheOther) {
  Random random(2);
  for (int k = 0; k < tern_test::scaled(100); ++k) {
    FarWorld world({24, 20, 6});
    build_blocks(random, world);
    const Vec3 start = world.centre(random_free(world.coarse.grid, random));
    const Vec3 goal = world.centre(random_free(world.coarse.grid, random));
    if (tern_test::ReferenceSearch(world.coarse.grid)
            .cost(world.coarse.grid.voxel_of(start), world.coarse.grid.voxel_of(goal)) < 0.0) {
      continue;
    }
    world.begin(goal, {15.0});
    const std::vector<Vec3> all = world.near_goals(start);
    ASSERT_FALSE(all.empty());
    Vec3 before = start;
    for (const Vec3& at : all) {
      EXPECT_TRUE(world.coarse.grid.free(world.coarse.grid.voxel_of(at)));
      EXPECT_LE(std::hypot(at.x - before.x, std::hypot(at.y - before.y, at.z - before.z)), 15.0 + 1e-9);
      before = at;
    }
    EXPECT_EQ(before.x, goal.x);
    EXPECT_FALSE(world.tick(goal));
    EXPECT_NEAR(world.far.left(), 0.0, 1e-9);
  }
}

TEST(FarWay, LeadsAroundACourtThatTheCoarseGridKnows) {
  FarWorld world({32, 32, 4});
  // A court that is open towards the start: 56 m deep, and as high as the grid.
  world.block({{80.0, 36.0, 0.0}, {84.0, 92.0, 16.0}});
  world.block({{28.0, 36.0, 0.0}, {84.0, 40.0, 16.0}});
  world.block({{28.0, 88.0, 0.0}, {84.0, 92.0, 16.0}});
  world.begin({118.0, 64.0, 6.0});
  for (const Vec3& at : world.near_goals({10.0, 64.0, 6.0})) {
    EXPECT_FALSE(at.x > 28.0 && at.x < 84.0 && at.y > 36.0 && at.y < 92.0) << at.x << ' ' << at.y;
  }
}

bool wait(FarWorld& world, const Vec3& at, int ticks) {
  bool told = false;
  for (int k = 0; k < ticks; ++k) told = world.tick(at) || told;
  return told;
}

TEST(FarWay, LearnsOfAWallOnceTheVehicleGetsNoFurther) {
  FarWorld world({32, 32, 4}, {60.0, 32.0, 8.0});
  build_streets(world);
  const Vec3 at{50.0, 12.0, 6.0};
  world.find_way({20.0, 40.0, 6.0});
  wait(world, at, 2);
  const double short_way = world.far.left();
  EXPECT_FALSE(wait(world, at, 990));
  EXPECT_EQ(world.far.marked(), 0);
  EXPECT_TRUE(wait(world, at, 20));
  EXPECT_EQ(world.far.searches(), 2);
  EXPECT_GT(world.far.left(), short_way + 150.0);
  for (int y = 0; y < 6; ++y) {
    for (int z = 0; z < 4; ++z) EXPECT_TRUE(world.coarse.grid.obstacle({15, y, z}));
  }
  EXPECT_EQ(world.far.marked(), 24);  // the wall, and nothing else
}

/// The vehicle is in the cell that the wall's face closes. The free cell nearest to it is inside the wall, where nobody
/// has seen anything.
TEST(FarWay, DoesNotBeginBehindWhatIsSeen) {
  FarWorld world({32, 32, 4}, {60.0, 32.0, 8.0});
  world.block({{40.0, 24.0, 0.0}, {88.0, 116.0, 16.0}});
  world.begin({116.0, 40.0, 6.0});
  EXPECT_EQ(world.seen.map.mark_box({{59.5, 0.0, 0.0}, {60.0, 24.0, 16.0}}), Status::kOk);
  const Vec3 at{58.8, 12.0, 6.0};
  EXPECT_TRUE(wait(world, at, 2));
  EXPECT_LT(world.far.left(), 100.0);
  EXPECT_TRUE(wait(world, at, 1010));
  EXPECT_TRUE(world.coarse.grid.obstacle({14, 3, 1}));
  EXPECT_FALSE(world.coarse.grid.obstacle({15, 3, 1}));
  EXPECT_GT(world.far.left(), 200.0);
}

TEST(FarWay, ABlockSeenAFewVoxelsOffTeachesNothing) {
  FarWorld world({32, 32, 4}, {60.0, 32.0, 8.0});
  world.block({{40.0, 24.0, 0.0}, {88.0, 116.0, 16.0}});
  world.begin({116.0, 40.0, 6.0});
  world.seen.map.mark_box({{39.5, 23.0, 0.0}, {88.0, 72.0, 16.0}});
  world.seen.map.mark_box({{28.0, 8.0, 0.0}, {92.0, 24.0, 1.0}});  // the ground, at the grid's rim
  EXPECT_TRUE(wait(world, {50.0, 12.0, 6.0}, 2));
  EXPECT_FALSE(wait(world, {50.0, 12.0, 6.0}, 3000));
  EXPECT_EQ(world.far.marked(), 0);
}

TEST(FarWay, AVehicleThatGivesUpNeedNotWait) {
  FarWorld world({32, 32, 4}, {60.0, 32.0, 8.0});
  build_streets(world);
  world.find_way({20.0, 40.0, 6.0});
  wait(world, {50.0, 12.0, 6.0}, 2);
  bool told = false;
  for (int k = 0; k < 10 && !told; ++k) told = world.tick({50.0, 12.0, 6.0}, true);
  EXPECT_TRUE(told);
  EXPECT_EQ(world.far.marked(), 24);
}

TEST(FarWay, WhereNothingIsSeenTheCellAheadLeadsNowhere) {
  FarWorld world({32, 32, 4});
  world.begin({122.0, 62.0, 6.0});
  const Vec3 at{6.0, 62.0, 6.0};
  world.find_way(at);
  for (int k = 1; k <= 5; ++k) {
    ASSERT_TRUE(world.tick(at, true));
    EXPECT_EQ(world.far.marked(), k);
    EXPECT_EQ(world.far.state(), FarState::kLeads);
  }
  EXPECT_TRUE(world.coarse.grid.obstacle({2, 15, 1}));
}

TEST(FarWay, GivesUpWithTheVehicleIfNoCellIsLeft) {
  FarWorld world({6, 1, 1});
  world.begin({22.0, 2.0, 2.0}, {12.0});
  const Vec3 at{2.0, 2.0, 2.0};
  world.find_way(at);
  ASSERT_FALSE(world.far.is_last());
  EXPECT_TRUE(world.tick(at, true));  // the way ends where the vehicle is
  EXPECT_TRUE(world.far.is_last());
  EXPECT_FALSE(world.tick(at, true));
}

TEST(FarWay, HasTheSameBitsInSlices) {
  const auto run = [](std::uint32_t work) {
    FarWorld world({32, 32, 4}, {60.0, 32.0, 8.0});
    build_streets(world);
    std::vector<Vec3> all;
    for (int k = 0; k < 20000 && all.size() < 2; ++k) {
      if (world.tick({50.0, 12.0, 6.0}, false, work)) all.push_back(world.far.near_goal());
    }
    return all;
  };
  const std::vector<Vec3> whole = run(kMuch);
  const std::vector<Vec3> sliced = run(1);
  ASSERT_EQ(whole.size(), 2u);
  ASSERT_EQ(sliced.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(whole[k].x, sliced[k].x);
    EXPECT_EQ(whole[k].y, sliced[k].y);
    EXPECT_EQ(whole[k].z, sliced[k].z);
  }
}

TEST(FarWay, BeginsInACellThatIsNotFree) {
  FarWorld world({32, 32, 4});
  world.block({{8.0, 8.0, 0.0}, {21.0, 40.0, 16.0}});  // its last cells reach 3 m beyond it
  world.begin({100.0, 20.0, 6.0});
  world.find_way({22.0, 20.0, 6.0});
  EXPECT_EQ(world.far.state(), FarState::kLeads);
  EXPECT_GT(world.far.left(), 70.0);
}

TEST(FarWay, LeadsToAGoalInACellThatIsNotFree) {
  FarWorld world({32, 32, 4});
  world.block({{8.0, 8.0, 0.0}, {21.0, 40.0, 16.0}});
  const Vec3 goal{22.0, 20.0, 6.0};
  world.begin(goal);
  const std::vector<Vec3> all = world.near_goals({100.0, 20.0, 6.0});
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all.back().x, goal.x);
}

TEST(FarWay, WithoutAWayLeadsToTheGoal) {
  FarWorld world({32, 32, 4});
  world.begin({200.0, 20.0, 6.0});  // outside the coarse grid
  EXPECT_TRUE(world.tick({22.0, 20.0, 6.0}));
  EXPECT_EQ(world.far.state(), FarState::kNoWay);
  EXPECT_EQ(world.far.near_goal().x, 200.0);
  EXPECT_FALSE(world.tick({22.0, 20.0, 6.0}, true));
  EXPECT_EQ(world.far.left(), 0.0);
}

TEST(FarWay, AMarkOfTheCallersBeginsTheSearchAnew) {
  FarWorld world({32, 32, 4});
  world.begin({122.0, 62.0, 6.0});
  world.tick({6.0, 62.0, 6.0}, false, 1);
  world.block({{60.0, 0.0, 0.0}, {64.0, 100.0, 16.0}});
  world.coarse.grid.inflate();
  world.find_way({6.0, 62.0, 6.0});
  EXPECT_EQ(world.far.searches(), 2);
  EXPECT_GT(world.far.left(), 140.0);
  world.block({{60.0, 100.0, 0.0}, {64.0, 116.0, 16.0}});  // set_goal() inflates
  ASSERT_EQ(world.far.set_goal({122.0, 62.0, 6.0}), Status::kOk);
  world.find_way({6.0, 62.0, 6.0});
  EXPECT_GT(world.far.left(), 160.0);
}

TEST(FarWay, Refuses) {
  FarWorld world({8, 8, 4});
  FarWay far;
  EXPECT_EQ(far.set_goal({1.0, 1.0, 1.0}), Status::kInvalidArgument);
  EXPECT_EQ(far.start({40.0}, world.coarse.grid, world.planner), Status::kInvalidArgument);  // not inflated
  world.coarse.grid.inflate();
  EXPECT_EQ(far.start({0.0}, world.coarse.grid, world.planner), Status::kInvalidArgument);
  EXPECT_EQ(far.start({11.99}, world.coarse.grid, world.planner), Status::kInvalidArgument);  // less than three cells
  EXPECT_EQ(FarWay{}.start({12.0}, world.coarse.grid, world.planner), Status::kOk);
  EXPECT_EQ(FarWay{}.start({1024.0}, world.coarse.grid, world.planner), Status::kOk);
  EXPECT_EQ(far.start({1024.01}, world.coarse.grid, world.planner), Status::kInvalidArgument);  // more than 256 cells
  EXPECT_EQ(far.start({40.0, 0}, world.coarse.grid, world.planner), Status::kInvalidArgument);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(far.start({nan}, world.coarse.grid, world.planner), Status::kNonFiniteInput);
  EXPECT_FALSE(far.tick({1.0, 1.0, 1.0}, {}, world.seen.map, 0, kMuch));
  ASSERT_EQ(far.start({40.0}, world.coarse.grid, world.planner), Status::kOk);
  EXPECT_EQ(far.set_goal({nan, 1.0, 1.0}), Status::kNonFiniteInput);
  EXPECT_EQ(far.state(), FarState::kNoGoal);
  ASSERT_EQ(far.set_goal({20.0, 1.0, 1.0}), Status::kOk);
  EXPECT_FALSE(far.tick({nan, 1.0, 1.0}, {}, world.seen.map, 0, kMuch));
  EXPECT_TRUE(far.tick({1.0, 1.0, 1.0}, {}, world.seen.map, 0, kMuch));
}

/// 5 x 5 x 0.15 km in cells of 4 m: blocks of 60 m with streets of 20 m, from corner to corner.
TEST(FarWay, ACityFitsTheCompanion) {
  if (tern::kMaxCells < 1250ll * 1250 * 37) GTEST_SKIP() << "a smaller profile";
  FarWorld world({1250, 1250, 37});
  Random random(1);
  for (double x = 20.0; x < 4940.0; x += 80.0) {
    for (double y = 20.0; y < 4940.0; y += 80.0) {
      world.block({{x, y, 0.0}, {x + 60.0, y + 60.0, random.real(15.0, 148.0)}});
    }
  }
  world.begin({4990.0, 4990.0, 10.0});
  std::uint32_t ticks = 0;
  while (world.far.state() == FarState::kSearching && ticks < 1000) {
    world.tick({10.0, 10.0, 10.0}, false, 2000);
    ++ticks;
  }
  EXPECT_EQ(world.far.state(), FarState::kLeads);
  EXPECT_LT(ticks, 200u);
  EXPECT_GT(world.far.left(), 7000.0);
  EXPECT_LT(world.far.left(), 8000.0);
}

}  // namespace
