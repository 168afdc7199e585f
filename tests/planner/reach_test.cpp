// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Goals that cannot be planned to: what the report says, and plans that go as near as they can.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "base/math.hpp"
#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Fence;
using tern::FenceKind;
using tern::GoalMode;
using tern::Stage;
using tern::Status;
using tern::Vec3;

/// 8 x 4 x 2 m at 0.1 m, radius 0.25, away from the world's origin. A wall at 4 <= x <= 4.2 divides it: voxels that end
/// at x = 3.7 are free, 3.8 is closer to the wall than 0.25.
class ReachPlan : public testing::Test {
 protected:
  ReachPlan() : world_({80, 40, 20}, 0.1, 0.25, {10.0, -20.0, 5.0}) {
    world_.from({1.0, 1.0, 1.0}).to({6.0, 2.04, 1.03});
  }
  void wall() { world_.block({4.0, 0.0, 0.0}, {4.2, 4.0, 2.0}); }
  const tern::Report& report() const { return world_.report; }
  const tern::StageReport& stage(Stage s) const { return report().diagnostics.stages[static_cast<int>(s)]; }

  void expect_point(const Vec3& p, const Vec3& relative) {
    const Vec3 expected = relative + world_.spec.origin;
    for (int a = 0; a < 3; ++a) EXPECT_NEAR(tern::axis(p, a), tern::axis(expected, a), 1e-12);
  }
  void expect_missed(Status why, const Vec3& relative) {
    ASSERT_EQ(world_.plan(), Status::kOk);
    EXPECT_EQ(report().goal_missed, why);
    EXPECT_TRUE(report().has_reachable);
    expect_point(report().reachable, relative);
    const tern::Sample end = tern::evaluate(world_.trajectory, tern::duration(world_.trajectory));
    EXPECT_LE(tern::distance(end.position, report().reachable), 1e-9);
    EXPECT_EQ(tern::dot(end.velocity, end.velocity), 0.0);
    for (const tern::StageReport& s : report().diagnostics.stages) EXPECT_LE(s.work, s.bound);
  }

  World world_;
};

TEST_F(ReachPlan, AReportSaysHowNearAPathComes) {
  wall();
  EXPECT_EQ(world_.plan(), Status::kNoPath);
  EXPECT_TRUE(world_.trajectory_untouched());
  EXPECT_EQ(report().stage, Stage::kSearch);
  EXPECT_TRUE(report().has_reachable);
  EXPECT_EQ(report().goal_missed, Status::kOk);
  expect_point(report().reachable, {3.65, 2.05, 1.05});
  EXPECT_GT(stage(Stage::kReach).work, 0u);
  EXPECT_LE(stage(Stage::kReach).work, stage(Stage::kReach).bound);
}

TEST_F(ReachPlan, GoesAsNearAsItCanWhereNoPathLeadsToTheGoal) {
  wall();
  world_.request.goal_mode = GoalMode::kNearest;
  expect_missed(Status::kNoPath, {3.65, 2.05, 1.05});
  EXPECT_EQ(report().quality, tern::Quality::kOptimised);
}

TEST_F(ReachPlan, GoesAsNearAsItCanToAnOccupiedGoal) {
  world_.block({5.8, 1.8, 0.0}, {6.2, 2.2, 2.0});
  EXPECT_EQ(world_.plan(), Status::kGoalOccupied);
  EXPECT_TRUE(report().raw_occupied);
  EXPECT_TRUE(report().has_nearest_free);
  EXPECT_TRUE(report().has_reachable);
  world_.request.goal_mode = GoalMode::kNearest;
  // Free are y >= 2.5, whose first centre is 0.51 m away; x >= 6.5 and x <= 5.5 are 0.55 m away.
  expect_missed(Status::kGoalOccupied, {5.95, 2.55, 1.05});
  EXPECT_FALSE(report().raw_occupied);
  EXPECT_FALSE(report().has_nearest_free);
}

// The goal touches the lower face of a block, so the planner tries to arrive there from a point before it. What counts
// is how near the robot comes to the goal, not to that point.
TEST(ReachGoalInMotion, TheNearestPointIsTheOneNearestToTheGoal) {
  World world({80, 40, 20}, 0.1, 0.0);
  world.block({5.0, 1.8, 0.0}, {6.2, 2.2, 0.1}).from({1.0, 1.0, 1.0}).to({6.02, 1.99, 0.0});
  world.request.goal.velocity = {1.0, 0.0, 0.0};
  EXPECT_EQ(world.plan(), Status::kGoalTooNarrow);
  EXPECT_FALSE(world.report.raw_occupied);
  ASSERT_TRUE(world.report.has_reachable);
  // Above the block; beside it, centres are 0.24 m away.
  EXPECT_LE(tern::distance(world.report.reachable, {6.05, 1.95, 0.15}), 1e-12);
}

TEST_F(ReachPlan, GoesAsNearAsItCanToAFencedGoal) {
  tern::Halfspace planes[tern::kBoxPlanes];
  tern::box_planes({{15.0, -30.0, 0.0}, {30.0, 0.0, 10.0}}, planes);  // beyond 5 m from the grid's origin
  const Fence fence{planes, tern::kBoxPlanes, FenceKind::kKeepOut};
  world_.request.fences = &fence;
  world_.request.fence_count = 1;
  EXPECT_EQ(world_.plan(), Status::kGoalFenced);
  EXPECT_EQ(report().stage, Stage::kRequest);
  EXPECT_EQ(report().field, tern::Field::kGoalPosition);
  EXPECT_EQ(report().fence, 0);
  ASSERT_TRUE(report().has_reachable);
  expect_point(report().reachable, {4.65, 2.05, 1.05});
  world_.request.goal_mode = GoalMode::kNearest;
  expect_missed(Status::kGoalFenced, {4.65, 2.05, 1.05});
  EXPECT_EQ(report().fence, 0);
}

TEST_F(ReachPlan, AGoalThatCanBePlannedToGetsTheSamePlan) {
  world_.block({4.0, 0.0, 0.0}, {4.2, 3.0, 2.0});
  ASSERT_EQ(world_.plan(), Status::kOk);
  const tern::Trajectory exact = world_.trajectory;
  world_.request.goal_mode = GoalMode::kNearest;
  ASSERT_EQ(world_.replan(), Status::kOk);
  EXPECT_EQ(std::memcmp(&exact, &world_.trajectory, sizeof exact), 0);
  EXPECT_FALSE(report().has_reachable);
  EXPECT_EQ(report().goal_missed, Status::kOk);
}

TEST_F(ReachPlan, StaysWhereNothingIsNearer) {
  wall();
  world_.from({3.61, 2.02, 1.02});  // in the voxel that is nearest to the goal
  world_.request.goal_mode = GoalMode::kNearest;
  expect_missed(Status::kNoPath, {3.61, 2.02, 1.02});
  EXPECT_EQ(report().quality, tern::Quality::kHover);
}

TEST_F(ReachPlan, ComesToRestThereFromMotion) {
  wall();
  world_.request.start.velocity = {1.0, 0.5, 0.0};
  world_.request.goal.velocity = {1.0, 0.0, 0.0};
  world_.request.goal_mode = GoalMode::kNearest;
  expect_missed(Status::kNoPath, {3.65, 2.05, 1.05});
  EXPECT_NEAR(tern::evaluate(world_.trajectory, 0.0).velocity.x, 1.0, 1e-12);
}

TEST_F(ReachPlan, FollowsThePreviousPlanThereWhereThatIsAllThereIs) {
  wall();
  world_.request.goal_mode = GoalMode::kNearest;
  ASSERT_EQ(world_.plan(), Status::kOk);
  const tern::Trajectory previous = world_.trajectory;
  const double half = 0.5 * tern::duration(previous);
  const tern::Sample now = tern::evaluate(previous, half);
  world_.request.start = {now.position, now.velocity, now.acceleration, now.jerk};
  world_.request.previous = &previous;
  world_.request.previous_time = half;
  expect_missed(Status::kNoPath, {3.65, 2.05, 1.05});
  // With no budget for a corridor of its own there is the previous plan, which ends at the same point.
  world_.request.budget.shortcut = 0;
  expect_missed(Status::kNoPath, {3.65, 2.05, 1.05});
  EXPECT_EQ(report().quality, tern::Quality::kPrevious);
}

TEST_F(ReachPlan, SlicesGiveTheSameBits) {
  wall();
  world_.request.goal_mode = GoalMode::kNearest;
  ASSERT_EQ(world_.plan(), Status::kOk);
  const tern::Trajectory whole = world_.trajectory;
  for (const std::uint32_t slice : {1u, 7u, 100u}) {
    Status status = world_.planner.begin(world_.grid, world_.request);
    while (status == Status::kRunning) status = world_.planner.step(slice);
    ASSERT_EQ(world_.planner.finish(world_.trajectory, world_.report), Status::kOk);
    EXPECT_EQ(std::memcmp(&whole, &world_.trajectory, sizeof whole), 0);
    EXPECT_EQ(report().goal_missed, Status::kNoPath);
  }
}

TEST_F(ReachPlan, TheBudgetOfTheSearchHoldsForAllOfIt) {
  wall();
  ASSERT_EQ(world_.plan(), Status::kNoPath);
  ASSERT_EQ(world_.plan(), Status::kNoPath);  // from now on, the search's tables are made
  const auto searched = static_cast<std::uint32_t>(stage(Stage::kSearch).work);
  const auto flooded = static_cast<std::uint32_t>(stage(Stage::kReach).work);
  world_.request.budget.search = searched + flooded;
  EXPECT_EQ(world_.plan(), Status::kNoPath);
  EXPECT_TRUE(report().has_reachable);
  world_.request.budget.search = searched + flooded / 2;
  EXPECT_EQ(world_.plan(), Status::kNoPath);
  EXPECT_FALSE(report().has_reachable);
  world_.request.goal_mode = GoalMode::kNearest;
  EXPECT_EQ(world_.plan(), Status::kBudgetSearch);
  EXPECT_EQ(report().stage, Stage::kReach);
  // The search for the way there spends from it, too.
  world_.request.budget.search = searched + flooded + 1000;
  EXPECT_EQ(world_.plan(), Status::kOk);
  EXPECT_GT(stage(Stage::kSearch).work, searched);
}

TEST_F(ReachPlan, AStartThatIsOccupiedReachesNothing) {
  world_.block({0.8, 0.8, 0.0}, {1.2, 1.2, 2.0});
  world_.request.goal_mode = GoalMode::kNearest;
  EXPECT_EQ(world_.plan(), Status::kStartOccupied);
  EXPECT_FALSE(report().has_reachable);
}

// No path is looked for to a fenced goal. The start is looked at once something is to be reached.
TEST_F(ReachPlan, AStartThatIsOccupiedReachesNothingNearAFencedGoal) {
  tern::Halfspace planes[tern::kBoxPlanes];
  tern::box_planes({{15.0, -30.0, 0.0}, {30.0, 0.0, 10.0}}, planes);
  const Fence fence{planes, tern::kBoxPlanes, FenceKind::kKeepOut};
  world_.request.fences = &fence;
  world_.request.fence_count = 1;
  world_.block({0.8, 0.8, 0.0}, {1.2, 1.2, 2.0});
  for (const GoalMode mode : {GoalMode::kExact, GoalMode::kNearest}) {
    world_.request.goal_mode = mode;
    EXPECT_EQ(world_.plan(), Status::kGoalFenced);
    EXPECT_EQ(report().stage, Stage::kRequest);
    EXPECT_FALSE(report().has_reachable);
    EXPECT_TRUE(world_.trajectory_untouched());
  }
}

TEST_F(ReachPlan, AnUnknownModeIsRefused) {
  world_.request.goal_mode = static_cast<GoalMode>(2);
  EXPECT_EQ(world_.plan(), Status::kInvalidArgument);
  EXPECT_EQ(report().field, tern::Field::kGoalMode);
}

}  // namespace
}  // namespace tern_test
