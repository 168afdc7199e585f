// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans through vias: where they pass, how fast, and what the report says of a via that they cannot pass.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "base/math.hpp"
#include "planner/vias_room.hpp"
#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Quality;
using tern::Status;
using tern::Via;

TEST_F(ViasPlan, FliesThroughAPointOffTheStraightWay) {
  via({4.0, 3.0, 1.0});
  ASSERT_EQ(plan(), Status::kOk);
  expect_passes();
  EXPECT_EQ(report().quality, Quality::kOptimised);
  EXPECT_EQ(report().vias[0].distance, 0.0) << "through the point itself";
  EXPECT_GT(speed(passage(0)), 0.5);
}

TEST_F(ViasPlan, CarriesItsSpeedThroughAViaOnTheStraightWay) {
  ASSERT_EQ(plan(), Status::kOk);
  const double without = tern::duration(world_.trajectory);
  via({4.0, 1.0, 1.0});
  ASSERT_EQ(plan(), Status::kOk);
  expect_passes();
  EXPECT_LE(tern::duration(world_.trajectory), 1.1 * without);
  EXPECT_GT(speed(passage(0)), 1.0);
}

TEST_F(ViasPlan, StopsWhereItIsAskedTo) {
  via({4.0, 3.0, 1.0}).stop = true;
  via({5.0, 2.0, 1.2});
  ASSERT_EQ(plan(), Status::kOk);
  expect_passes();
  EXPECT_EQ(report().quality, Quality::kOptimised);
  EXPECT_LE(speed(passage(0)), 1e-9);
  EXPECT_LE(tern::length(passage(0).acceleration), 1e-7);
  EXPECT_GT(speed(passage(1)), 0.2);
}

TEST_F(ViasPlan, HasTheVelocityThatIsAskedFor) {
  Via& fast = via({4.0, 2.0, 1.0});
  fast.has_velocity = true;
  fast.velocity = {0.5, 1.25, -0.25};
  ASSERT_EQ(plan(), Status::kOk);
  expect_passes();
  EXPECT_EQ(report().quality, Quality::kOptimised);
  EXPECT_LE(tern::distance(passage(0).velocity, fast.velocity), 1e-9);
}

TEST_F(ViasPlan, AToleranceMakesTheWayShorter) {
  world_.request.time_weight = 1000.0;
  via({4.0, 3.0, 1.0});
  ASSERT_EQ(plan(), Status::kOk);
  const double through = tern::duration(world_.trajectory);
  vias_[0].tolerance = 0.5;
  ASSERT_EQ(plan(), Status::kOk);
  expect_passes();
  EXPECT_GT(report().vias[0].distance, 0.05);
  EXPECT_LT(tern::duration(world_.trajectory), through);
}

TEST_F(ViasPlan, KeepsTheOrder) {
  via({6.0, 3.0, 1.0});
  via({2.0, 3.0, 1.0});
  via({6.0, 1.5, 1.0});
  ASSERT_EQ(plan(), Status::kOk);
  expect_passes();
  EXPECT_LT(report().vias[0].time, report().vias[1].time);
  EXPECT_LT(report().vias[1].time, report().vias[2].time);
}

TEST_F(ViasPlan, StopAndGoPassesEveryVia) {
  via({4.0, 3.0, 1.0}).tolerance = 0.2;
  via({4.5, 1.0, 1.0});
  world_.request.budget.trajectory = 0;
  ASSERT_EQ(plan(), Status::kOk);
  EXPECT_EQ(report().quality, Quality::kStopAndGo);
  expect_passes();
  for (std::size_t v = 0; v < 2; ++v) EXPECT_LE(speed(passage(v)), 1e-9);
}

TEST_F(ViasPlan, TheSamePointTwiceAndTheEndsAreVias) {
  via({1.0, 1.0, 1.0});
  via({4.0, 2.0, 1.0});
  via({4.0, 2.0, 1.0});
  via({7.0, 1.0, 1.0});
  ASSERT_EQ(plan(), Status::kOk);
  expect_passes();
}

TEST_F(ViasPlan, HoversWhereEverythingIsOnePoint) {
  world_.to({1.0, 1.0, 1.0});
  via({1.0, 1.0, 1.0});
  ASSERT_EQ(plan(), Status::kOk);
  EXPECT_EQ(report().quality, Quality::kHover);
  expect_passes();
}

TEST_F(ViasPlan, BeginsAndEndsInMotion) {
  world_.request.start.velocity = {1.0, 0.5, 0.0};
  world_.request.goal.velocity = {0.5, -0.5, 0.0};
  via({3.0, 2.5, 1.0});
  via({5.0, 2.5, 1.0});
  ASSERT_EQ(plan(), Status::kOk);
  expect_passes();
  EXPECT_LE(tern::distance(passage(0).position, vias_[0].position), 1e-9);
}

TEST_F(ViasPlan, AStartThatMustStopFirstStillPassesItsVias) {
  world_.from({1.0, 0.4, 1.0});
  world_.request.start.velocity = {0.0, -1.0, 0.0};  // towards the boundary 0.4 m away
  world_.request.limits = {{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};
  via({3.0, 2.5, 1.0});
  ASSERT_EQ(plan(), Status::kOk);
  expect_passes();
}

// No programme that begins towards the boundary has a solution, but one along the segments from stop to stop has.
// From a via to itself there is no such segment, so there the plan stays what it is.
TEST_F(ViasPlan, AStartThatMustStopFirstPassesTheSamePointTwiceFromStopToStop) {
  world_.from({1.0, 0.375, 1.0});  // exact in doubles: a via and the goal are one point in any frame
  world_.request.start.velocity = {0.0, -1.0, 0.0};
  for (const Quality quality : {Quality::kOptimised, Quality::kStopAndGo}) {
    via({3.0, 2.5, 1.0});
    ASSERT_EQ(plan(), Status::kOk);
    EXPECT_EQ(report().quality, quality) << vias_.size();
    expect_passes();
  }
  vias_.pop_back();
  via({7.0, 1.0, 1.0});  // nor from a via to the goal, in the same place
  ASSERT_EQ(plan(), Status::kOk);
  EXPECT_EQ(report().quality, Quality::kStopAndGo);
  expect_passes();
}

TEST_F(ViasPlan, SlicesChangeNoBit) {
  via({4.0, 3.0, 1.0}).tolerance = 0.1;
  via({6.0, 2.0, 1.0}).stop = true;
  ASSERT_EQ(plan(), Status::kOk);
  const tern::Trajectory whole = world_.trajectory;
  ASSERT_EQ(world_.planner.begin(world_.grid, world_.request), Status::kRunning);
  while (world_.planner.step(1) == Status::kRunning) {
  }
  ASSERT_EQ(world_.planner.finish(world_.trajectory, world_.report), Status::kOk);
  ASSERT_EQ(world_.trajectory.count, whole.count);
  for (int i = 0; i < whole.count; ++i) {
    EXPECT_EQ(world_.trajectory.segments[i].duration, whole.segments[i].duration);
    EXPECT_EQ(
        std::memcmp(world_.trajectory.segments[i].points, whole.segments[i].points, sizeof whole.segments[i].points),
        0);
  }
}

TEST_F(ViasPlan, ThePathLeadsThroughTheVias) {
  via({4.0, 3.0, 1.0});
  ASSERT_EQ(plan(), Status::kOk);
  const tern::Path* path = world_.planner.path();
  ASSERT_NE(path, nullptr);
  int met = 0;
  for (int i = 0; i < path->count; ++i) met += tern::distance(path->points[i], {4.0, 3.0, 1.0}) < 1e-12 ? 1 : 0;
  EXPECT_EQ(met, 1);
  EXPECT_NEAR(path->length, 2.0 * std::sqrt(13.0), 1e-9);
}

}  // namespace
}  // namespace tern_test
