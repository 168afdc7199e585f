// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Vias that cannot be passed, and lists of them that are refused.

#include <gtest/gtest.h>

#include <limits>

#include "base/math.hpp"
#include "planner/vias_room.hpp"
#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Fence;
using tern::Field;
using tern::kNoVia;
using tern::Stage;
using tern::Status;
using tern::Via;

TEST_F(ViasPlan, AViaBehindAWallHasNoPath) {
  world_.block({4.0, 0.0, 0.0}, {4.2, 4.0, 2.0});
  world_.to({3.0, 3.0, 1.0});
  via({2.0, 2.0, 1.0});
  via({6.0, 2.0, 1.0});
  EXPECT_EQ(plan(), Status::kNoPath);
  EXPECT_EQ(report().stage, Stage::kSearch);
  EXPECT_EQ(report().via, 1);
  EXPECT_TRUE(report().has_reachable);
  EXPECT_NEAR(report().reachable.x, at({3.65, 0, 0}).x, 1e-9);
  EXPECT_TRUE(world_.trajectory_untouched());
}

TEST_F(ViasPlan, AGoalBehindAWallIsNoVia) {
  world_.block({4.0, 0.0, 0.0}, {4.2, 4.0, 2.0});
  via({2.0, 2.0, 1.0});
  EXPECT_EQ(plan(), Status::kNoPath);
  EXPECT_EQ(report().via, kNoVia);
}

TEST_F(ViasPlan, AViaInAnObstacleIsOccupied) {
  world_.block({4.0, 2.0, 0.0}, {4.5, 2.5, 2.0});
  via({2.0, 2.0, 1.0});
  via({4.25, 2.25, 1.0});
  EXPECT_EQ(plan(), Status::kViaOccupied);
  EXPECT_EQ(report().via, 1);
  EXPECT_TRUE(report().raw_occupied);
  EXPECT_TRUE(report().has_nearest_free);
}

TEST_F(ViasPlan, AStartInAnObstacleIsNoFaultOfAVia) {
  world_.block({0.5, 0.5, 0.5}, {1.5, 1.5, 1.5});
  via({2.0, 2.0, 1.0});
  EXPECT_EQ(plan(), Status::kStartOccupied);
  EXPECT_EQ(report().via, kNoVia);
  EXPECT_TRUE(report().raw_occupied);
}

TEST_F(ViasPlan, AFencedViaNamesBoth) {
  tern::Halfspace faces[2][tern::kBoxPlanes];
  tern::box_planes({at({0.0, 3.9, 0.0}), at({0.5, 4.0, 2.0})}, faces[0]);
  tern::box_planes({at({3.0, 2.0, 0.0}), at({4.0, 3.0, 2.0})}, faces[1]);
  const Fence fences[] = {{faces[0], tern::kBoxPlanes, tern::FenceKind::kKeepOut},
                          {faces[1], tern::kBoxPlanes, tern::FenceKind::kKeepOut}};
  world_.request.fences = fences;
  world_.request.fence_count = 2;
  via({3.5, 2.5, 1.0});
  EXPECT_EQ(plan(), Status::kViaFenced);
  EXPECT_EQ(report().via, 0);
  EXPECT_EQ(report().fence, 1);
  vias_[0].position = at({3.5, 1.5, 1.0});
  ASSERT_EQ(plan(), Status::kOk);
  expect_passes();
}

TEST_F(ViasPlan, RefusesWhatIsNoVia) {
  via({2.0, 2.0, 1.0});
  via({4.0, 2.0, 1.0});
  const Via good = vias_[1];
  vias_[1].position.x = std::numeric_limits<double>::quiet_NaN();
  expect_refused(Status::kNonFiniteInput, 1);
  vias_[1] = good;
  vias_[1].tolerance = -0.1;
  expect_refused(Status::kInvalidArgument, 1);
  vias_[1] = good;
  vias_[1].stop = vias_[1].has_velocity = true;
  expect_refused(Status::kInvalidArgument, 1);
  vias_[1] = good;
  vias_[1].position = at({9.0, 1.0, 1.0});
  expect_refused(Status::kOutOfMap, 1);
  vias_[1] = good;
  vias_[1].has_velocity = true;
  vias_[1].velocity = {2.1, 0.0, 0.0};
  expect_refused(Status::kViaExceedsLimits, 1);
}

TEST_F(ViasPlan, RefusesTooManyAndNone) {
  for (int v = 0; v <= tern::kMaxVias; ++v) via({4.0, 2.0, 1.0});
  expect_refused(Status::kViasFull, kNoVia);
  vias_.clear();
  world_.request.via_count = 1;
  world_.request.vias = nullptr;
  EXPECT_EQ(world_.plan(), Status::kInvalidArgument);
  EXPECT_EQ(report().field, Field::kVias);
  world_.request.via_count = -1;
  EXPECT_EQ(world_.plan(), Status::kInvalidArgument);
  EXPECT_EQ(report().field, Field::kVias);
}

TEST_F(ViasPlan, TakesAsManyAsFit) {
  for (int v = 0; v < tern::kMaxVias; ++v) via({1.2 + 0.35 * v, v % 2 == 0 ? 1.5 : 2.5, 1.0});
  ASSERT_EQ(plan(), Status::kOk);
  expect_passes();
}

TEST_F(ViasPlan, TakesNoPreviousPlanAndNoNearestGoal) {
  ASSERT_EQ(plan(), Status::kOk);
  const tern::Trajectory flown = world_.trajectory;
  via({4.0, 2.0, 1.0});
  world_.request.previous = &flown;
  EXPECT_EQ(plan(), Status::kInvalidArgument);
  EXPECT_EQ(report().field, Field::kPrevious);
  world_.request.previous = nullptr;
  world_.request.goal_mode = tern::GoalMode::kNearest;
  EXPECT_EQ(plan(), Status::kInvalidArgument);
  EXPECT_EQ(report().field, Field::kGoalMode);
}

}  // namespace
}  // namespace tern_test
