// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where nothing new is found, the rest of the previous plan is flown. A search that may not expand a node finds
// nothing.
#include "planner/previous.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "base/math.hpp"
#include "planner/attempts.hpp"
#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Field;
using tern::Quality;
using tern::Sample;
using tern::Status;

class PreviousPlan : public testing::Test {
 protected:
  PreviousPlan() : world_({60, 40, 20}, 0.1, 0.2) {
    world_.block({2.9, 0.0, 0.0}, {3.1, 2.6, 2.0}).from({1.0, 1.0, 1.0}).to({5.0, 1.0, 1.0});
    EXPECT_EQ(world_.plan(), Status::kOk);
    first_ = world_.trajectory;
  }
  /// The state of the first plan, with that plan behind it.
  void ask_from(double time) {
    const Sample now = evaluate(first_, time);
    world_.request.start = {now.position, now.velocity, now.acceleration, now.jerk};
    world_.request.previous = &first_;
    world_.request.previous_time = time;
    world_.request.budget.search = 0;
  }
  /// The output is not touched before.
  Status plan_over() { return world_.planner.plan(world_.grid, world_.request, world_.trajectory, world_.report); }
  void expect_refused(Status status) {
    EXPECT_EQ(world_.replan(), status);
    EXPECT_EQ(world_.report.field, Field::kPrevious);
  }
  /// The answer is the first plan from that time on: it has the same bits, but for the polyhedra.
  void expect_same_flight(double time) {
    EXPECT_EQ(world_.report.quality, Quality::kPrevious);
    EXPECT_EQ(world_.report.entered, time);
    const tern::Trajectory& rest = world_.trajectory;
    EXPECT_EQ(rest.begin, first_.begin);
    EXPECT_TRUE(same(rest.origin, first_.origin));
    ASSERT_EQ(rest.count, first_.count);
    for (int i = 0; i < rest.count; ++i) {
      EXPECT_EQ(rest.segments[i].polyhedron, tern::kNoPolyhedron);
      EXPECT_EQ(rest.segments[i].duration, first_.segments[i].duration);
      EXPECT_EQ(std::memcmp(rest.segments[i].points, first_.segments[i].points, sizeof rest.segments[i].points), 0);
    }
  }

  World world_;
  tern::Trajectory first_;
};

TEST_F(PreviousPlan, IsFlownOnWhereNothingNewIsFound) {
  for (const double part : {0.0, 0.01, 0.3, 0.5, 0.77, 0.99}) {
    const double time = part * duration(first_);
    ask_from(time);
    ASSERT_EQ(world_.replan(), Status::kOk) << part;
    EXPECT_EQ(world_.report.diagnostics.detours, tern::detours_of(tern::Attempt::kFollow));
    EXPECT_GT(world_.report.diagnostics.stages[static_cast<int>(tern::Stage::kPrevious)].work, 0u);
    for (const tern::StageReport& stage : world_.report.diagnostics.stages) EXPECT_LE(stage.work, stage.bound);
    expect_same_flight(time);
  }
}

TEST_F(PreviousPlan, IsLeftWhereANewOneArrivesEarlier) {
  ask_from(0.4 * duration(first_));
  world_.request.budget.search = 0xFFFFFFFFu;
  world_.request.time_weight = tern::kMinTimeWeight;  // a new plan takes its time
  ASSERT_EQ(world_.replan(), Status::kOk);
  EXPECT_EQ(world_.report.optimiser, Status::kOk);
  EXPECT_EQ(world_.planner.corridor(), nullptr);
  EXPECT_EQ(world_.trajectory.segments[0].polyhedron, tern::kNoPolyhedron);
  for (const tern::StageReport& stage : world_.report.diagnostics.stages) EXPECT_LE(stage.work, stage.bound);
  expect_same_flight(0.4 * duration(first_));
  world_.request.time_weight = tern::kDefaultTimeWeight;
  world_.request.limits = {{4.0, 4.0, 4.0}, {6.0, 6.0, 6.0}};
  ASSERT_EQ(world_.replan(), Status::kOk);
  EXPECT_EQ(world_.report.quality, Quality::kOptimised);
  EXPECT_EQ(world_.report.entered, 0.0);
  EXPECT_LT(duration(world_.trajectory), 0.6 * duration(first_) - 1e-6);
}

TEST_F(PreviousPlan, SetsThePaceOfANewOne) {
  // With higher limits there is an earlier plan. The old durations lead to it in fewer iterations.
  ask_from(0.3 * duration(first_));
  world_.request.budget.search = 0xFFFFFFFFu;
  world_.request.limits = {{4.0, 4.0, 4.0}, {6.0, 6.0, 6.0}};
  world_.request.time_weight = 1000.0;
  ASSERT_EQ(world_.replan(), Status::kOk);
  ASSERT_EQ(world_.report.quality, Quality::kOptimised);
  const std::uint32_t iterations = world_.report.diagnostics.stages[static_cast<int>(tern::Stage::kTrajectory)].work;
  const double seconds = duration(world_.trajectory);
  world_.request.previous = nullptr;
  ASSERT_EQ(world_.replan(), Status::kOk);
  EXPECT_LT(iterations, world_.report.diagnostics.stages[static_cast<int>(tern::Stage::kTrajectory)].work);
  EXPECT_LT(seconds, 1.03 * duration(world_.trajectory));
}

TEST_F(PreviousPlan, SetsTheSamePaceInSlices) {
  ask_from(0.3 * duration(first_));
  world_.request.budget.search = 0xFFFFFFFFu;
  world_.request.limits = {{4.0, 4.0, 4.0}, {6.0, 6.0, 6.0}};
  ASSERT_EQ(world_.replan(), Status::kOk);
  ASSERT_EQ(world_.report.quality, Quality::kOptimised);
  const tern::Trajectory whole = world_.trajectory;
  ASSERT_EQ(world_.planner.begin(world_.grid, world_.request), Status::kRunning);
  world_.request.previous = nullptr;  // read by begin() alone
  const std::uint32_t most = 1u << 20;
  Status status = Status::kRunning;
  for (std::uint32_t i = 0; i < most && status == Status::kRunning; ++i) status = world_.planner.step(1);
  ASSERT_EQ(world_.planner.finish(world_.trajectory, world_.report), Status::kOk);
  ASSERT_EQ(world_.trajectory.count, whole.count);
  for (int i = 0; i < whole.count; ++i) {
    EXPECT_EQ(
        std::memcmp(&world_.trajectory.segments[i].points, &whole.segments[i].points, sizeof whole.segments[i].points),
        0)
        << i;
    EXPECT_EQ(world_.trajectory.segments[i].duration, whole.segments[i].duration) << i;
  }
}

TEST_F(PreviousPlan, LeadsNowhereElseFromRest) {
  ask_from(0.0);
  world_.request.goal.position = {5.0, 3.0, 1.0};
  EXPECT_EQ(world_.replan(), Status::kBudgetSearch);
  EXPECT_EQ(world_.report.diagnostics.stages[static_cast<int>(tern::Stage::kPrevious)].work, 0u);
}

TEST_F(PreviousPlan, LeadsToNoOtherGoalThatIsOccupied) {
  ask_from(0.3 * duration(first_));
  world_.request.budget.search = 0xFFFFFFFFu;
  world_.request.goal.position = {3.0, 1.0, 1.0};  // in the wall
  EXPECT_EQ(world_.replan(), Status::kGoalOccupied);
  EXPECT_EQ(world_.report.diagnostics.stages[static_cast<int>(tern::Stage::kPrevious)].work, 0u);
}

TEST_F(PreviousPlan, MayBeTheOutput) {
  ask_from(0.4 * duration(first_));
  world_.request.previous = &world_.trajectory;
  ASSERT_EQ(plan_over(), Status::kOk);
  expect_same_flight(0.4 * duration(first_));
}

TEST_F(PreviousPlan, IsFollowedAgainAndAgain) {
  const double step = duration(first_) / 40.0;
  ask_from(step);
  for (int k = 0; k < 38; ++k) {
    ASSERT_EQ(plan_over(), Status::kOk) << k;
    expect_same_flight(world_.request.previous_time);
    const double time = world_.report.entered + step;
    const Sample now = evaluate(world_.trajectory, time);
    world_.request.start = {now.position, now.velocity, now.acceleration, now.jerk};
    world_.request.previous = &world_.trajectory;
    world_.request.previous_time = time;
  }
}

TEST_F(PreviousPlan, LeadsIntoAMotionToo) {
  world_.request.goal.velocity = {0.5, 0.0, 0.0};
  ASSERT_EQ(world_.replan(), Status::kOk);
  first_ = world_.trajectory;
  ask_from(0.5 * duration(first_));
  ASSERT_EQ(world_.replan(), Status::kOk);
  expect_same_flight(0.5 * duration(first_));
}

TEST_F(PreviousPlan, IsLedOnFromWhereTheGoalMovesInstead) {
  ask_from(0.5 * duration(first_));
  world_.request.budget.search = 0xFFFFFFFFu;
  world_.request.goal.velocity = {0.0, 0.5, 0.0};
  ASSERT_EQ(world_.replan(), Status::kOk);
  EXPECT_NE(world_.report.quality, Quality::kPrevious);
  EXPECT_EQ(world_.report.entered, 0.0);
  const tern::Segment& last = world_.trajectory.segments[world_.trajectory.count - 1];
  EXPECT_NEAR((last.points[7].y - last.points[6].y) * 7.0 / last.duration, 0.5, 1e-9);
}

TEST_F(PreviousPlan, KeepsItsClock) {
  first_.begin = 5000000000;
  const std::int64_t now = first_.begin + static_cast<std::int64_t>(0.4e9 * duration(first_));
  ask_from(tern::time_on(first_, now));
  world_.request.begin = now;
  ASSERT_EQ(world_.replan(), Status::kOk);
  expect_same_flight(world_.request.previous_time);
  EXPECT_EQ(tern::time_on(world_.trajectory, now), world_.report.entered);
  // A new plan has the request's.
  world_.request.budget.search = 0xFFFFFFFFu;
  world_.request.limits = {{4.0, 4.0, 4.0}, {6.0, 6.0, 6.0}};
  ASSERT_EQ(world_.replan(), Status::kOk);
  ASSERT_EQ(world_.report.quality, Quality::kOptimised);
  EXPECT_EQ(world_.trajectory.begin, now);
  EXPECT_TRUE(same(world_.trajectory.origin, world_.request.start.position));
}

/// Only what is still to be flown is proven.
TEST_F(PreviousPlan, IsFollowedPastWhatIsBlockedBehindIt) {
  const double time = 0.7 * duration(first_);
  const tern::Vec3 behind = evaluate(first_, 0.3 * duration(first_)).position;
  world_.block(behind - tern::Vec3{0.1, 0.1, 0.1}, behind + tern::Vec3{0.1, 0.1, 0.1});
  world_.grid.inflate();
  ask_from(time);
  ASSERT_EQ(world_.replan(), Status::kOk);
  expect_same_flight(time);
  ask_from(0.05 * duration(first_));
  EXPECT_EQ(world_.replan(), Status::kBudgetSearch);
}

TEST_F(PreviousPlan, ProvesNothingWhereTheMapChanged) {
  ask_from(0.2 * duration(first_));
  const tern::Vec3 ahead = evaluate(first_, 0.8 * duration(first_)).position;
  world_.block({ahead.x - 0.1, ahead.y - 0.1, ahead.z - 0.1}, {ahead.x + 0.1, ahead.y + 0.1, ahead.z + 0.1});
  world_.grid.inflate();
  EXPECT_EQ(world_.replan(), Status::kBudgetSearch);
  EXPECT_EQ(world_.report.quality, Quality::kNone);
}

TEST_F(PreviousPlan, ProvesNothingOutsideANewFence) {
  ask_from(0.2 * duration(first_));
  const tern::Halfspace below{{1.0, 0.0, 0.0}, 3.5};  // x <= 3.5, where the goal is not
  const tern::Fence fence{&below, 1, tern::FenceKind::kKeepIn};
  world_.request.fences = &fence;
  world_.request.fence_count = 1;
  EXPECT_EQ(world_.replan(), Status::kGoalFenced);
  world_.request.goal = {{3.4, 3.0, 1.0}, {}, {}};
  EXPECT_EQ(world_.replan(), Status::kBudgetSearch);
}

TEST_F(PreviousPlan, IsFollowedUntilNothingIsLeft) {
  for (const double before : {1.1e-3, 0.9e-3, 1e-6, 1e-12, 0.0}) {
    for (const double end : {first_.segments[0].duration, duration(first_)}) {
      const double time = end - before;
      ask_from(time);
      ASSERT_EQ(world_.replan(), Status::kOk) << before;
      if (time < duration(first_)) expect_same_flight(time);
    }
  }
}

TEST_F(PreviousPlan, HasTheStateBitForBit) {
  ask_from(0.4 * duration(first_));
  const tern::State start = world_.request.start;
  world_.request.start.position.x = std::nextafter(start.position.x, 10.0);
  expect_refused(Status::kInvalidArgument);
  world_.request.start = start;
  world_.request.start.velocity.y = std::nextafter(start.velocity.y, 10.0);
  expect_refused(Status::kInvalidArgument);
  world_.request.start = start;
  world_.request.start.acceleration.x = std::nextafter(start.acceleration.x, 10.0);
  expect_refused(Status::kInvalidArgument);
}

TEST_F(PreviousPlan, IsATrajectory) {
  ask_from(0.4 * duration(first_));
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  world_.request.previous_time = kNaN;
  expect_refused(Status::kNonFiniteInput);
  world_.request.previous_time = -1.0;
  expect_refused(Status::kInvalidArgument);
  world_.request.previous_time = 0.4 * duration(first_);
  tern::Trajectory bad = first_;
  world_.request.previous = &bad;
  for (const int count : {0, -1, tern::kMaxSegments + 1}) {
    bad.count = count;
    expect_refused(Status::kInvalidArgument);
  }
  bad = first_;
  bad.segments[bad.count - 1].points[3].y = kNaN;
  expect_refused(Status::kInvalidArgument);
  for (const double none : {0.0, -1.0, kNaN, std::numeric_limits<double>::infinity()}) {
    bad = first_;
    bad.segments[bad.count - 1].duration = none;
    expect_refused(Status::kInvalidArgument);
  }
  bad = first_;
  bad.origin.z = std::numeric_limits<double>::infinity();
  expect_refused(Status::kInvalidArgument);
}

TEST_F(PreviousPlan, IsOverPastItsEnd) {
  ask_from(2.0 * duration(first_));
  world_.request.budget.search = 0xFFFFFFFFu;
  ASSERT_EQ(world_.replan(), Status::kOk);
  EXPECT_EQ(world_.report.quality, Quality::kHover);
}

}  // namespace
}  // namespace tern_test
