// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Far ways: what a tick spends, what counts as marked, and how far ahead near goals must be.
#include <gtest/gtest.h>

#include <cmath>

#include "base/math.hpp"
#include "support/far_world.hpp"
#include "support/random.hpp"
#include "tern/far_way.hpp"

namespace {

using tern::Status;
using tern::Vec3;
using tern_test::FarWorld;
using tern_test::Random;

/// With the least `ahead`, in small steps: there is always a new near goal before the vehicle is at the last one.
TEST(FarWayWork, ANewNearGoalComesBeforeTheVehicleArrives) {
  Random random(3);
  for (int k = 0; k < tern_test::scaled(60); ++k) {
    FarWorld world({24, 20, 6});
    tern_test::build_blocks(random, world);
    Vec3 at = world.centre(tern_test::random_free(world.coarse.grid, random));
    world.begin(world.centre(tern_test::random_free(world.coarse.grid, random)),
                {tern::kLeastAhead * tern_test::kCoarse});
    world.find_way(at);
    const double pace = random.real(0.1, 0.9);
    for (int m = 0; m < 5000 && !world.far.is_last(); ++m) {
      const Vec3 to = world.far.near_goal() - at;
      const double away = std::sqrt(to.x * to.x + to.y * to.y + to.z * to.z);
      ASSERT_GT(away, pace) << k;
      at = at + (pace / away) * to;
      world.tick(at);
    }
    EXPECT_TRUE(world.far.is_last()) << k;
  }
}

TEST(FarWayWork, DoesNothingWithoutWork) {
  FarWorld world({32, 32, 4});
  world.begin({122.0, 62.0, 6.0});
  for (int k = 0; k < 10; ++k) EXPECT_FALSE(world.tick({6.0, 62.0, 6.0}, false, 0));
  EXPECT_EQ(world.far.searches(), 0);
  EXPECT_TRUE(world.tick({6.0, 62.0, 6.0}));
  const double left = world.far.left();
  for (int k = 0; k < 10; ++k) EXPECT_FALSE(world.tick({26.0, 62.0, 6.0}, false, 0));
  EXPECT_EQ(world.far.left(), left);
  EXPECT_TRUE(world.tick({26.0, 62.0, 6.0}));
  EXPECT_NEAR(world.far.left(), left - 20.0, 1e-9);
}

/// A look that passes hundreds of cells takes many units. They are paid before anything else is done.
TEST(FarWayWork, PaysForALongLook) {
  FarWorld world({200, 4, 4});
  world.begin({798.0, 6.0, 6.0}, {700.0});
  ASSERT_TRUE(world.tick({2.0, 6.0, 6.0}));
  ASSERT_FALSE(world.far.is_last());
  const double left = world.far.left();
  ASSERT_TRUE(world.tick({10.0, 6.0, 6.0}, false, 1));
  ASSERT_LT(world.far.left(), left);
  const double then = world.far.left();
  for (int k = 0; k < 50; ++k) EXPECT_FALSE(world.tick({18.0, 6.0, 6.0}, false, 1));
  EXPECT_EQ(world.far.left(), then);
}

/// The longest look that there is, across all rows. One tick in which a flight does nothing else pays for it.
TEST(FarWayWork, TheLongestLookTakesATick) {
  if (tern::kMaxCells < 200 * 200 * 200) GTEST_SKIP() << "a smaller profile";
  FarWorld world({200, 200, 200});
  world.begin({798.0, 798.0, 798.0}, {tern::kMostAhead * tern_test::kCoarse});
  world.find_way({2.0, 2.0, 2.0});
  ASSERT_FALSE(world.far.is_last());
  ASSERT_TRUE(world.tick({10.0, 10.0, 10.0}, false, 1));
  const double left = world.far.left();
  int unpaid = 0;
  for (; unpaid < 100000 && world.far.left() == left; ++unpaid) world.tick({18.0, 18.0, 18.0}, false, 1);
  EXPECT_GT(unpaid, 100);
  EXPECT_LT(unpaid, 4000);
}

/// A way with more than a hundred legs, near its end: the legs behind the vehicle cost nothing.
TEST(FarWayWork, LegsBehindCostNothing) {
  FarWorld world({160, 8, 1});
  for (int k = 0; k < 38; ++k) {
    const double x = 12.0 + 16.0 * k;
    const double y = k % 2 == 0 ? 0.0 : 4.0;
    world.block({{x + 1.0, y + 1.0, 0.0}, {x + 3.0, y + 27.0, 4.0}});
  }
  world.begin({638.0, 2.0, 2.0}, {12.0});
  Vec3 at{2.0, 2.0, 2.0};
  world.find_way(at);
  for (int k = 0; k < 2000 && world.far.left() > 60.0; ++k) {
    at = world.far.near_goal();
    world.tick(at);
  }
  ASSERT_FALSE(world.far.is_last());
  const Vec3 step = (1.0 / 40.0) * (world.far.near_goal() - at);
  for (int k = 0; k < 5; ++k) {
    const double left = world.far.left();
    at = at + step;
    world.tick(at, false, 1);
    EXPECT_LT(world.far.left(), left) << k;
  }
}

/// The window meets no coarse cell, so nothing is learned. The caller has marked the way since, up to a last cell: the
/// walk to the one behind it takes two steps a cell.
TEST(FarWayWork, PaysForTheWalkToTheCellThatIsMarked) {
  const auto ticks_to_next_search = [](int last) {
    FarWorld world({200, 1, 1}, {-200.0, 0.0, 8.0});
    world.begin({798.0, 2.0, 2.0});
    const Vec3 at{2.0, 2.0, 2.0};
    world.find_way(at);
    world.block({{5.0, 1.0, 1.0}, {4.0 * last + 3.0, 3.0, 3.0}});
    world.coarse.grid.inflate();
    while (world.far.marked() == 0) world.tick(at, true, 1);
    EXPECT_TRUE(world.coarse.grid.obstacle({last + 1, 0, 0}));
    int ticks = 0;
    for (; ticks < 1000 && world.far.searches() < 2; ++ticks) world.tick(at, true, 1);
    return ticks;
  };
  EXPECT_GE(ticks_to_next_search(197), ticks_to_next_search(1) + 8);
}

/// A goal that is set while the vehicle learns: what it marked so far counts.
TEST(FarWayWork, CountsWhatWasMarkedBeforeANewGoal) {
  FarWorld world({32, 32, 4}, {60.0, 32.0, 8.0});
  tern_test::build_streets(world);
  const Vec3 at{50.0, 12.0, 6.0};
  world.find_way(at);
  while (!world.coarse.grid.obstacle({15, 2, 0})) world.tick(at, true, 1);
  ASSERT_FALSE(world.coarse.grid.obstacle({15, 5, 3}));  // not all of the wall yet
  ASSERT_EQ(world.far.set_goal({116.0, 44.0, 6.0}), Status::kOk);
  world.find_way(at);
  int walls = 0;
  for (int y = 0; y < 6; ++y) {
    for (int z = 0; z < 4; ++z) walls += world.coarse.grid.obstacle({15, y, z}) ? 1 : 0;
  }
  EXPECT_EQ(world.far.marked(), walls);
}

}  // namespace
