// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What plans answer where things cover an end or block the way, and tracks that are none.

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "planner/among.hpp"
#include "support/random.hpp"
#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Field;
using tern::Stage;
using tern::Status;
using tern::Track;
using tern::TrackEnd;
using tern::TrackShape;

/// A keep-out that lies at the goal from 5 s to 90 s, and until 90 s it cannot be waited for.
TEST_F(Among, SaysWhenACoveredGoalIsFree) {
  Track parked = ball({7.45, 2.05, 1.05}, {0.0, 0.0, 0.0});
  parked.until = 90 * kSecond;
  parked.end = TrackEnd::kGone;
  ASSERT_EQ(plan({parked}), Status::kGoalCovered);
  EXPECT_NEAR(world_.report.goal_free, 90.0, 2e-3);
  EXPECT_GE(world_.report.goal_free, 90.0 - 1e-9);
  // Another one comes twenty seconds later, too soon for a rest of thirty.
  Track next = parked;
  next.measured = 110 * kSecond;
  next.until = 130 * kSecond;
  ASSERT_EQ(plan({parked, next}), Status::kGoalCovered);
  EXPECT_NEAR(world_.report.goal_free, 90.0, 2e-3);
  world_.request.rest_clear = 30.0;
  ASSERT_EQ(plan({parked, next}), Status::kGoalCovered);
  EXPECT_NEAR(world_.report.goal_free, 130.0, 2e-3);
  parked.end = TrackEnd::kGoesOn;
  ASSERT_EQ(plan({parked}), Status::kGoalCovered);
  EXPECT_EQ(world_.report.goal_free, kForever);
  const tern::StageReport& stage = world_.report.diagnostics.stages[static_cast<int>(Stage::kTracks)];
  EXPECT_LE(stage.work, stage.bound);
  // Sooner than the longest wait ends, but by then the way is closed for good. Unless also the places beside the goal
  // are, the vehicle waits there.
  parked.until = 30 * kSecond;
  parked.end = TrackEnd::kGone;
  parked.shape = TrackShape::kCylinder;
  parked.half.z = 1.0;
  Track closes = ball({4.0, 2.05, 1.05}, {0.0, 0.0, 0.0}, 3.0);
  closes.measured = 10 * kSecond;
  Track right = closes;
  right.shape = TrackShape::kBox;
  right.position = {7.0, 0.75, 1.05};
  right.half = {1.0, 0.75, 1.0};
  Track left = right;
  left.position.y = 3.35;
  world_.request.rest_clear = 2.0;
  EXPECT_EQ(plan({parked, closes}), Status::kOk);
  expect_plan();
  ASSERT_EQ(plan({parked, closes, right, left}), Status::kGoalCovered);
  EXPECT_NEAR(world_.report.goal_free, 30.0, 2e-3);
  EXPECT_EQ(plan({ball({4.0, 2.05, 1.05}, {0.0, 0.0, 0.0}, 5.0)}), Status::kStartInContact);
  EXPECT_EQ(world_.report.goal_free, kForever);
}

TEST_F(Among, ArrivesWhenTheGoalIsFree) {
  Track parked = ball({7.45, 2.05, 1.05}, {0.0, 0.0, 0.0});
  parked.end = TrackEnd::kGone;
  parked.until = 15 * kSecond;
  ASSERT_EQ(plan({parked}), Status::kOk);
  expect_plan();
  EXPECT_GE(tern::duration(world_.trajectory), 15.0);
  EXPECT_LT(tern::duration(world_.trajectory), 20.0);
  parked.end = TrackEnd::kGoesOn;
  EXPECT_EQ(plan({ball({1.0, 0.2, 1.0}, {0.0, 0.0, 0.0}), parked}), Status::kGoalCovered);
  expect_refused(Status::kGoalCovered, 1);
  EXPECT_EQ(world_.report.stage, Stage::kTracks);
  EXPECT_GT(world_.report.conflict, 3.0);
  // Something is in the way, too, but that is not why there is no plan.
  ASSERT_EQ(plan({}), Status::kOk);
  const double alone = tern::duration(world_.trajectory);
  EXPECT_EQ(plan({ball({4.0, 2.05, 1.05}, {0.0, 0.0, 0.0}), parked}), Status::kGoalCovered);
  expect_refused(Status::kGoalCovered, 1);
  EXPECT_NEAR(world_.report.conflict, alone, 0.05);
}

/// Of two things at the goal, the one that leaves last counts.
TEST_F(Among, WhatCoversTheGoalLastIsNamed) {
  Track leaves = ball({7.45, 2.05, 1.05}, {0.0, 0.0, 0.0});
  leaves.until = 90 * kSecond;
  leaves.end = TrackEnd::kGone;
  Track stays = ball({7.45, 2.1, 1.05}, {0.0, 0.0, 0.0});
  EXPECT_EQ(plan({leaves, stays}), Status::kGoalCovered);
  EXPECT_EQ(world_.report.track, 1);
  EXPECT_EQ(plan({stays, leaves}), Status::kGoalCovered);
  EXPECT_EQ(world_.report.track, 0);
  EXPECT_EQ(world_.report.goal_free, kForever);
}

/// A budget that ends while it is looked when the goal is free says so, and nothing else.
TEST_F(Among, ABudgetThatEndsAtTheGoalIsTheAnswer) {
  Track parked = ball({7.45, 2.05, 1.05}, {0.0, 0.0, 0.0});
  parked.until = 90 * kSecond;
  parked.end = TrackEnd::kGone;
  ASSERT_EQ(plan({parked}), Status::kGoalCovered);
  const std::uint32_t work = world_.report.diagnostics.stages[static_cast<int>(Stage::kTracks)].work;
  for (std::uint32_t budget = work - 700; budget < work; budget += 7) {
    world_.request.budget.tracks = budget;
    EXPECT_EQ(plan({parked}), Status::kBudgetTracks) << budget;
  }
}

TEST_F(Among, ABlockedWayHasNoClearTime) {
  Track wall = ball({4.0, 2.0, 1.0}, {0.0, 0.0, 0.0});
  wall.shape = TrackShape::kBox;
  wall.half = {0.1, 3.0, 3.0};
  EXPECT_EQ(plan({wall}), Status::kNoClearTime);
  expect_refused(Status::kNoClearTime, 0);
  EXPECT_GT(world_.report.conflict, 1.0);
  EXPECT_LT(world_.report.conflict, 5.0);
  wall.end = TrackEnd::kGone;
  wall.until = 30 * kSecond;
  ASSERT_EQ(plan({wall}), Status::kOk);
  expect_plan();
  EXPECT_GE(tern::duration(world_.trajectory), 30.0);
}

TEST_F(Among, LeavesWhatIsTooNearAtTheStart) {
  ASSERT_EQ(plan({ball({0.15, 2.05, 1.05}, {0.0, 0.0, 0.0})}), Status::kOk);
  expect_plan();
  EXPECT_EQ(world_.report.track, 0);
  EXPECT_EQ(world_.report.waits, 0.0);
  EXPECT_EQ(plan({ball({0.55, 2.05, 1.05}, {0.0, 0.0, 0.0})}), Status::kStartInContact);
  expect_refused(Status::kStartInContact, 0);
  EXPECT_EQ(world_.report.conflict, 0.0);
  // The thing is ahead: straight on, the way leads nearer, but there is one that leads away first.
  ASSERT_EQ(plan({ball({1.0, 2.05, 1.05}, {0.0, 0.0, 0.0})}), Status::kOk);
  expect_plan();
  EXPECT_EQ(world_.report.track, 0);
}

TEST_F(Among, TheEndStaysClearForAsLongAsItIsAskedTo) {
  // It comes to the goal after twelve seconds.
  const Track coming = ball({7.45, -9.5, 1.05}, {0.0, 1.0, 0.0});
  ASSERT_EQ(plan({coming}), Status::kOk);
  expect_plan();
  const double alone = tern::duration(world_.trajectory);
  EXPECT_NEAR(world_.report.rest_clear_until, 11.55 - 0.5, 0.02);
  world_.request.rest_clear = 10.0;
  ASSERT_EQ(plan({coming}), Status::kOk);
  expect_plan(10.0);
  EXPECT_GT(tern::duration(world_.trajectory), 12.0);
  EXPECT_GT(tern::duration(world_.trajectory), alone);
  EXPECT_EQ(world_.report.rest_clear_until, kForever);
}

TEST_F(Among, RefusesWhatIsNoTrack) {
  Track track = ball({1.0, 1.0, 1.0}, {0.0, 0.0, 0.0});
  track.error = -1.0;
  EXPECT_EQ(plan({Track{}, track}), Status::kInvalidArgument);
  expect_refused(Status::kInvalidArgument, 1);
  EXPECT_EQ(world_.report.field, Field::kTracks);
  track.error = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(plan({track}), Status::kNonFiniteInput);
  EXPECT_EQ(plan(std::vector<Track>(tern::kMaxTracks + 1)), Status::kTracksFull);
  expect_refused(Status::kTracksFull, tern::kNoTrack);
  std::vector<tern::TrackPiece> pieces(tern::kMaxTrackPieces + 1, tern::TrackPiece{1.0, {}});
  track = Track{};
  track.pieces = pieces.data();
  track.piece_count = tern::kMaxTrackPieces + 1;
  EXPECT_EQ(plan({track}), Status::kTrackPiecesFull);
  track.piece_count = tern::kMaxTrackPieces;
  EXPECT_EQ(plan({track}), Status::kOk);
  world_.request.track_count = -1;
  EXPECT_EQ(world_.plan(), Status::kInvalidArgument);
  EXPECT_EQ(world_.report.field, Field::kTracks);
  world_.request.track_count = 0;
  for (const double rest : {-1.0, 3601.0}) {
    world_.request.rest_clear = rest;
    EXPECT_EQ(world_.plan(), Status::kInvalidArgument);
    EXPECT_EQ(world_.report.field, Field::kRestClear);
  }
  world_.request.rest_clear = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(world_.plan(), Status::kNonFiniteInput);
}

}  // namespace
}  // namespace tern_test
