// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans among things that move: what is proven, and what waits.

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
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
using tern::Trajectory;
using tern::Vec3;

TEST_F(Among, WhatIsFarAwayChangesNothing) {
  ASSERT_EQ(world_.plan(), Status::kOk);
  EXPECT_EQ(world_.report.rest_clear_until, kForever);
  EXPECT_EQ(world_.report.track, tern::kNoTrack);
  const auto alone = std::make_unique<Trajectory>(world_.trajectory);
  const std::uint64_t check = world_.report.diagnostics.stages[static_cast<int>(Stage::kCheck)].bound;
  ASSERT_EQ(plan({ball({4.0, 3.9, 1.0}, {0.0, 0.0, 0.0})}), Status::kOk);
  EXPECT_EQ(std::memcmp(alone.get(), &world_.trajectory, sizeof(Trajectory)), 0);
  EXPECT_EQ(world_.report.rest_clear_until, kForever);
  EXPECT_EQ(world_.report.waits, 0.0);
  EXPECT_GT(world_.report.diagnostics.stages[static_cast<int>(Stage::kCheck)].bound, check);
  EXPECT_EQ(world_.report.diagnostics.stages[static_cast<int>(Stage::kTracks)].work, 0u);
}

TEST_F(Among, IsLedAroundWhatCrosses) {
  ASSERT_EQ(world_.plan(), Status::kOk);
  const double alone = tern::duration(world_.trajectory);
  // It is in the middle of the way when the plan is.
  const double half = 0.5 * alone;
  ASSERT_EQ(plan({ball({4.0, 2.05 - half, 1.05}, {0.0, 1.0, 0.0})}), Status::kOk);
  expect_plan();
  EXPECT_LT(tern::duration(world_.trajectory), 1.1 * alone);
  EXPECT_EQ(world_.report.waits, 0.0);
  EXPECT_EQ(world_.report.quality, tern::Quality::kOptimised);
  EXPECT_EQ(world_.report.diagnostics.seed, 1);
  for (const tern::StageReport& stage : world_.report.diagnostics.stages) EXPECT_LE(stage.work, stage.bound);
}

/// Plans that fly to and fro before a closed passage arrive hardly sooner than those that wait for it.
TEST_F(Among, WaitsRatherThanFliesAbout) {
  ASSERT_EQ(world_.plan(), Status::kOk);
  const auto alone = std::make_unique<Trajectory>(world_.trajectory);
  Track wall = ball({4.0, 2.0, 1.0}, {0.0, 0.0, 0.0});
  wall.shape = TrackShape::kBox;
  wall.half = {0.1, 3.0, 3.0};
  wall.end = TrackEnd::kGone;
  for (int until = 11; until <= 62; ++until) {
    wall.until = until * kSecond;
    ASSERT_EQ(plan({wall}), Status::kOk);
    expect_plan();
    // The shortest wait, to a fiftieth of a second, by proofs of the plan alone against a wall that much earlier.
    Track earlier = wall;
    tern::TrackGrounds grounds{&earlier, 1, world_.spec.radius, 0.0, true};
    tern::ProofReport found;
    int wait = 0;  // in fiftieths of a second
    do {
      ++wait;
      earlier.measured = wall.measured - wait * (kSecond / 50);
      earlier.until = wall.until - wait * (kSecond / 50);
      tern::clear_until(*alone, 0.0, grounds, &found);
    } while (found.finding != tern::Finding::kNone && wait < 50 * until);
    ASSERT_EQ(found.finding, tern::Finding::kNone);
    const double soonest = 0.02 * wait + tern::duration(*alone);
    EXPECT_NEAR(tern::duration(world_.trajectory), soonest, 0.05) << until;
    EXPECT_NEAR(world_.report.waits, 0.02 * wait, 0.05) << until;
    EXPECT_EQ(world_.report.diagnostics.seed, 0);
  }
}

/// A budget that ends while shorter waits are tried leaves the one that is clear.
TEST_F(Among, ABudgetThatEndsInTheWaitLeavesALongerOne) {
  Track wall = ball({4.0, 2.0, 1.0}, {0.0, 0.0, 0.0});
  wall.shape = TrackShape::kBox;
  wall.half = {0.1, 3.0, 3.0};
  wall.end = TrackEnd::kGone;
  wall.until = 27 * kSecond;
  ASSERT_EQ(plan({wall}), Status::kOk);
  const double shortest = world_.report.waits;
  const std::uint32_t work = world_.report.diagnostics.stages[static_cast<int>(Stage::kTracks)].work;
  bool was_found = false;
  int longer = 0;
  for (std::uint32_t budget = work - 600; budget <= work; budget += 5) {
    world_.request.budget.tracks = budget;
    const Status status = plan({wall});
    EXPECT_EQ(status, was_found ? Status::kOk : status) << budget;
    if (status != Status::kOk) continue;
    was_found = true;
    expect_plan();
    longer += world_.report.waits > shortest + 0.1 ? 1 : 0;
  }
  EXPECT_GT(longer, 0);
}

TEST_F(Among, WaitsForWhatTakesUpTheWholeWay) {
  ASSERT_EQ(world_.plan(), Status::kOk);
  const double alone = tern::duration(world_.trajectory);
  // A wall that is there until the plan without it is just past it.
  Track wall = ball({4.0, 2.0, 1.0}, {0.0, 0.0, 0.0});
  wall.shape = TrackShape::kBox;
  wall.half = {0.1, 3.0, 3.0};
  wall.end = TrackEnd::kGone;
  wall.until = 8 * kSecond;
  ASSERT_EQ(plan({wall}), Status::kOk);
  expect_plan();
  EXPECT_GT(tern::duration(world_.trajectory), 1.2 * alone);
  EXPECT_LE(world_.report.waits, tern::duration(world_.trajectory) - alone + 1e-9);
  const tern::StageReport& stage = world_.report.diagnostics.stages[static_cast<int>(Stage::kTracks)];
  EXPECT_GT(stage.work, 0u);
  EXPECT_LE(stage.work, stage.bound);
}

TEST_F(Among, TheClockSaysWhereThingsAre) {
  ASSERT_EQ(world_.plan(), Status::kOk);
  const auto alone = std::make_unique<Trajectory>(world_.trajectory);
  const double half = 0.5 * tern::duration(world_.trajectory);
  Track crossing = ball({4.0, 2.05 - half, 1.05}, {0.0, 1.0, 0.0});
  crossing.measured = 77 * kSecond;
  world_.request.begin = 77 * kSecond;
  ASSERT_EQ(plan({crossing}), Status::kOk);
  EXPECT_NE(std::memcmp(alone->segments, world_.trajectory.segments, sizeof(alone->segments)), 0);
  EXPECT_EQ(world_.trajectory.begin, 77 * kSecond);
  world_.request.begin = 97 * kSecond;
  ASSERT_EQ(plan({crossing}), Status::kOk);
  EXPECT_EQ(std::memcmp(alone->segments, world_.trajectory.segments, sizeof(alone->segments)), 0);
}

/// A wall across the way for a while, and rooms for a while.
struct ForAWhile {
  ForAWhile(tern::FenceKind kind, const Vec3& lower, const Vec3& upper, std::int64_t from, std::int64_t until) {
    tern::box_planes({lower, upper}, planes);
    fence = {planes, tern::kBoxPlanes, kind, from, until};
  }
  tern::Halfspace planes[tern::kBoxPlanes];
  tern::Fence fence;
};

TEST_F(Among, WaitsForAFenceToEnd) {
  ASSERT_EQ(world_.plan(), Status::kOk);
  const double alone = tern::duration(world_.trajectory);
  ForAWhile wall(tern::FenceKind::kKeepOut, {3.8, -1.0, -1.0}, {4.2, 5.0, 3.0}, 0, 6 * kSecond);
  world_.request.fences = &wall.fence;
  world_.request.fence_count = 1;
  ASSERT_EQ(world_.plan(), Status::kOk);
  expect_plan();
  EXPECT_GT(tern::duration(world_.trajectory), alone);
  // Its clock is five seconds off: it begins before it says, and ends later.
  const double exact = tern::duration(world_.trajectory);
  wall.fence.clock_error = 5.0;
  ASSERT_EQ(world_.plan(), Status::kOk);
  expect_plan();
  EXPECT_GT(tern::duration(world_.trajectory), exact + 2.0);
  // It never ends, but begins when the plan is past it.
  wall.fence = {wall.planes, tern::kBoxPlanes, tern::FenceKind::kKeepOut, static_cast<std::int64_t>(alone * 1e9),
                1000 * kSecond};
  ASSERT_EQ(world_.plan(), Status::kOk);
  EXPECT_DOUBLE_EQ(tern::duration(world_.trajectory), alone);
  wall.fence.from = kSecond;
  EXPECT_EQ(world_.plan(), Status::kNoClearTime);
  expect_refused(Status::kNoClearTime, tern::kNoTrack);
  EXPECT_EQ(world_.report.fence, 0);
  EXPECT_GT(world_.report.conflict, 1.0);
}

/// Two rooms, of which the second opens when the first one is nearly over.
TEST_F(Among, GoesFromRoomToRoom) {
  ASSERT_EQ(world_.plan(), Status::kOk);
  const double alone = tern::duration(world_.trajectory);
  ForAWhile first(tern::FenceKind::kKeepIn, {0.0, 0.0, 0.0}, {4.5, 4.0, 2.0}, -kSecond, 12 * kSecond);
  ForAWhile second(tern::FenceKind::kKeepIn, {3.5, 0.0, 0.0}, {8.0, 4.0, 2.0}, 8 * kSecond, 60 * kSecond);
  const tern::Fence fences[] = {first.fence, second.fence};
  world_.request.fences = fences;
  world_.request.fence_count = 2;
  ASSERT_EQ(world_.plan(), Status::kOk);
  expect_plan();
  EXPECT_GT(tern::duration(world_.trajectory), alone);
  EXPECT_NEAR(world_.report.rest_clear_until, 60.0, 1e-3);
  world_.request.rest_clear = 50.0;
  EXPECT_EQ(world_.plan(), Status::kGoalCovered);
  EXPECT_NEAR(world_.report.goal_free, 8.0, 2e-3);  // sooner than it is reached
  world_.request.rest_clear = 53.0;
  EXPECT_EQ(world_.plan(), Status::kGoalCovered);
  EXPECT_EQ(world_.report.goal_free, kForever);
}

TEST_F(Among, StopsFirstIfItBeginsInMotion) {
  ASSERT_EQ(world_.plan(), Status::kOk);
  world_.request.start.velocity = {1.0, 0.0, 0.0};
  const double half = 0.45 * tern::duration(world_.trajectory);
  Track across = ball({5.0, 2.05 - half, 1.05}, {0.0, 1.0, 0.0});
  across.shape = TrackShape::kCylinder;
  across.half.z = 2.0;
  const Status status = plan({across});
  ASSERT_EQ(status, Status::kOk);
  expect_plan();
}

TEST_F(Among, PassesItsViasAfterTheWait) {
  std::vector<tern::Via> vias(1);
  vias[0].position = {4.0, 2.05, 1.05};
  vias[0].tolerance = 0.2;
  world_.request.vias = vias.data();
  world_.request.via_count = 1;
  ASSERT_EQ(world_.plan(), Status::kOk);
  const double passed = world_.report.vias[0].time;
  ASSERT_EQ(plan({ball({4.0, 2.05 - passed, 1.05}, {0.0, 1.0, 0.0})}), Status::kOk);
  expect_plan();
  EXPECT_GT(world_.report.vias[0].time, passed);
  EXPECT_LE(world_.report.vias[0].distance, 0.2 + 1e-9);
}

TEST_F(Among, APreviousPlanIsFollowedOnlyIfItIsClear) {
  ASSERT_EQ(world_.plan(), Status::kOk);
  const auto before = std::make_unique<Trajectory>(world_.trajectory);
  const tern::Sample now = tern::evaluate(*before, 1.0);
  world_.request.start = {now.position, now.velocity, now.acceleration, now.jerk};
  world_.request.previous = before.get();
  world_.request.previous_time = 1.0;
  world_.request.begin = kSecond;
  const Track far = ball({4.0, 3.8, 1.0}, {0.0, 0.0, 0.0});
  ASSERT_EQ(plan({far}), Status::kOk);
  expect_plan();
  Track wall = ball({6.0, 2.0, 1.0}, {0.0, 0.0, 0.0});
  wall.shape = TrackShape::kBox;
  wall.half = {0.1, 3.0, 3.0};
  wall.end = TrackEnd::kGone;
  wall.until = 12 * kSecond;
  wall.measured = kSecond;
  ASSERT_EQ(plan({wall}), Status::kOk);
  expect_plan();
  EXPECT_NE(world_.report.quality, tern::Quality::kPrevious);
  EXPECT_GE(tern::duration(world_.trajectory), 10.0);
  world_.request.begin = 2 * kSecond;
  EXPECT_EQ(plan({far}), Status::kInvalidArgument);
  EXPECT_EQ(world_.report.field, Field::kPrevious);
}

TEST_F(Among, SlicesGiveTheSamePlan) {
  const Track crossing = ball({4.0, -1.0, 1.05}, {0.0, 1.0, 0.0});
  ASSERT_EQ(plan({crossing, ball({6.0, 6.0, 1.0}, {0.0, -1.0, 0.0})}), Status::kOk);
  const auto whole = std::make_unique<Trajectory>(world_.trajectory);
  Status status = world_.planner.begin(world_.grid, world_.request);
  // The tracks are copied.
  for (Track& track : tracks_) track = ball({4.0, 2.0, 1.0}, {0.0, 0.0, 0.0}, 9.0);
  while (status == Status::kRunning) status = world_.planner.step(7);
  ASSERT_EQ(world_.planner.finish(world_.trajectory, world_.report), Status::kOk);
  EXPECT_EQ(std::memcmp(whole.get(), &world_.trajectory, sizeof(Trajectory)), 0);
}

/// Random things in random number: each plan is proven by code of its own, and no refusal is for nothing.
TEST(AmongMany, PlansAreClear) {
  Random random(41);
  World world({80, 40, 20}, 0.1, 0.2);
  int planned = 0;
  int led_around = 0;
  const int cases = scaled(60);
  for (int i = 0; i < cases; ++i) {
    world.from({0.55, random.real(0.5, 3.5), 1.05}).to({7.45, random.real(0.5, 3.5), 1.05});
    std::vector<Track> tracks(static_cast<std::size_t>(random.integer(1, 10)));
    for (Track& track : tracks) {
      track = ball({random.real(1.5, 7.0), random.real(-2.0, 6.0), random.real(0.5, 1.5)},
                   {random.real(-1.0, 1.0), random.real(-1.0, 1.0), 0.0}, random.real(0.1, 0.3));
      track.error = 0.05;
      track.error_speed = 0.02;
    }
    world.request.tracks = tracks.data();
    world.request.track_count = static_cast<std::int32_t>(tracks.size());
    if (world.plan() != Status::kOk) continue;
    ++planned;
    led_around += world.report.diagnostics.seed >= 1 ? 1 : 0;
    const auto plan = std::make_unique<Trajectory>(world.trajectory);
    tern::TrackGrounds grounds;
    grounds.tracks = tracks.data();
    grounds.count = static_cast<std::int32_t>(tracks.size());
    grounds.radius = 0.2;
    grounds.leaves = true;
    tern::ProofReport found;
    tern::clear_until(*plan, 0.0, grounds, &found);
    EXPECT_EQ(found.finding, tern::Finding::kNone) << "case " << i;
  }
  EXPECT_GE(planned, cases * 2 / 3);
  if (cases > 20) {
    EXPECT_GT(led_around, cases / 10);
  }
}

}  // namespace
}  // namespace tern_test
