// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ends where the robot has room but no voxel is free: in motion, it comes to rest elsewhere first, or leaves from
// elsewhere.
#include <gtest/gtest.h>

#include "base/math.hpp"
#include "planner/attempts.hpp"
#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Status;
using tern::Vec3;

/// 8 x 4 x 2 m at 0.1 m, radius 0.19. Between x = 1 and x = 3 there is nothing but a tunnel 0.4 m wide: its middle
/// keeps the radius, and none of its voxels is free. Nor is any before x = 3.2, as seen from the tunnel, or any behind
/// 0.8.
class OccupiedEnds : public testing::Test {
 protected:
  OccupiedEnds() : world_({80, 40, 20}, 0.1, 0.19) {
    world_.block({1.0, 0.0, 0.0}, {3.0, 0.8, 2.0}).block({1.0, 1.2, 0.0}, {3.0, 4.0, 2.0});
    world_.from({5.0, 2.0, 1.0}).to({7.0, 1.0, 1.0});
  }
  tern::State& start() { return world_.request.start; }
  tern::State& goal() { return world_.request.goal; }
  const tern::Report& report() const { return world_.report; }
  void expect_refused(Status status, bool raw) {
    EXPECT_EQ(world_.plan(), status);
    EXPECT_EQ(report().stage, tern::Stage::kSearch);
    EXPECT_EQ(report().raw_occupied, raw);
    EXPECT_EQ(report().finer_cell, 0.0) << "occupied, or so narrow that no grid that fine fits";
    EXPECT_TRUE(report().has_nearest_free);
    EXPECT_EQ(report().diagnostics.stages[static_cast<int>(tern::Stage::kStopFirst)].work, 0u);
    EXPECT_TRUE(world_.trajectory_untouched());
  }

  World world_;
  const Vec3 inside_{2.0, 1.0, 1.0};    // the tunnel
  const Vec3 occupied_{2.0, 3.0, 1.0};  // an obstacle
  const Vec3 along_{1.0, 0.0, 0.0};     // stops within 0.275 m
};

TEST_F(OccupiedEnds, AtRestTheyAreRefused) {
  world_.from(inside_);
  expect_refused(Status::kStartTooNarrow, false);
  EXPECT_EQ(report().fence, tern::kNoFence);
  goal().velocity = along_;
  expect_refused(Status::kStartTooNarrow, false);
  world_.from({5.0, 2.0, 1.0}).to(inside_);
  goal().velocity = tern::kZero;
  expect_refused(Status::kGoalTooNarrow, false);
  start().velocity = along_;
  expect_refused(Status::kGoalTooNarrow, false);
}

TEST_F(OccupiedEnds, InAnObstacleMotionDoesNotHelp) {
  world_.from(occupied_);
  start().velocity = along_;
  expect_refused(Status::kStartOccupied, true);
  world_.from({5.0, 2.0, 1.0}).to(occupied_);
  start().velocity = tern::kZero;
  goal().velocity = along_;
  expect_refused(Status::kGoalOccupied, true);
}

TEST_F(OccupiedEnds, AStartThatLeavesTheTunnelStopsOutside) {
  world_.from({2.85, 1.0, 1.0});
  start().velocity = along_;
  ASSERT_EQ(world_.plan(), Status::kOk);
  EXPECT_EQ(report().diagnostics.detours, tern::detours_of(tern::Attempt::kStopFirst));
  EXPECT_NEAR(tern::evaluate(world_.trajectory, 0.0).velocity.x, 1.0, 1e-9);
  const Vec3 end = tern::evaluate(world_.trajectory, tern::duration(world_.trajectory)).position;
  EXPECT_LE(tern::distance(end, goal().position), 1e-9);
}

TEST_F(OccupiedEnds, AStartThatStopsOutsideStillPassesItsVias) {
  world_.from({2.85, 1.0, 1.0});
  start().velocity = along_;
  goal().velocity = along_;
  tern::Via via{};
  via.position = {5.0, 3.0, 1.0};
  world_.request.vias = &via;
  world_.request.via_count = 1;
  ASSERT_EQ(world_.plan(), Status::kOk);
  EXPECT_EQ(report().diagnostics.detours, tern::detours_of(tern::Attempt::kStopFirst));
  EXPECT_LE(tern::distance(tern::evaluate(world_.trajectory, report().vias[0].time).position, via.position), 1e-9);
}

TEST_F(OccupiedEnds, AGoalThatEntersTheTunnelIsLeftForFromOutside) {
  world_.from({0.5, 3.0, 1.0}).to({1.1, 1.0, 1.0});
  goal().velocity = along_;
  ASSERT_EQ(world_.plan(), Status::kOk);
  EXPECT_EQ(report().diagnostics.detours, tern::detours_of(tern::Attempt::kStopFirst));
  const tern::Segment& last = world_.trajectory.segments[world_.trajectory.count - 1];
  EXPECT_NEAR((last.points[7].x - last.points[6].x) * 7.0 / last.duration, 1.0, 1e-9);
}

TEST_F(OccupiedEnds, AStartDeepInTheTunnelIsRefusedAfterItsEscapes) {
  world_.from(inside_);
  start().velocity = along_;
  EXPECT_EQ(world_.plan(), Status::kStartTooNarrow);
  EXPECT_GT(report().diagnostics.stages[static_cast<int>(tern::Stage::kStopFirst)].work, 0u);
}

/// The way to a via where the plan starts is no way at all, and the next leg finds no voxel to begin in.
TEST_F(OccupiedEnds, AViaAtSuchAStartIsTooNarrow) {
  world_.from(inside_);
  tern::Via via{};
  via.position = inside_;
  world_.request.vias = &via;
  world_.request.via_count = 1;
  EXPECT_EQ(world_.plan(), Status::kViaTooNarrow);
  EXPECT_EQ(report().via, 0);
  EXPECT_FALSE(report().raw_occupied);
  EXPECT_TRUE(report().has_nearest_free);
  EXPECT_TRUE(world_.trajectory_untouched());
}

}  // namespace
}  // namespace tern_test
