// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The rest of a previous plan that leads elsewhere than to the goal, or does not hold.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "base/math.hpp"
#include "planner/attempts.hpp"
#include "planner/previous.hpp"
#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Stage;
using tern::Status;
using tern::Trajectory;
using tern::Vec3;

const tern::StageReport& stage(const World& world, Stage s) {
  return world.report.diagnostics.stages[static_cast<int>(s)];
}

void ask_from(World& world, const Trajectory& plan, double time) {
  const tern::Sample now = tern::evaluate(plan, time);
  world.request.start = {now.position, now.velocity, now.acceleration, now.jerk};
  world.request.previous = &plan;
  world.request.previous_time = time;
}

/// Straight on along x for `length` metres at 1 m/s, in as many segments as there may be.
Trajectory straight_on(const Vec3& from, double length) {
  Trajectory plan{};
  plan.origin = from;
  plan.count = tern::kMaxSegments;
  const double duration = length / tern::kMaxSegments;
  for (int i = 0; i < plan.count; ++i) {
    plan.segments[i].duration = duration;
    for (int k = 0; k < tern::kControlPoints; ++k) {
      plan.segments[i].points[k] = {duration * (i + k / static_cast<double>(tern::kDegree)), 0.0, 0.0};
    }
  }
  return plan;
}

/// A wall at 4 <= x <= 4.2 across the map: the way before it ends at x = 3.75, and nothing leads to the goal.
class RestBeforeAWall : public testing::Test {
 protected:
  RestBeforeAWall() : world_({80, 40, 20}, 0.1, 0.25) {
    world_.block({4.0, 0.0, 0.0}, {4.2, 4.0, 2.0}).to({6.0, 2.0, 1.0});
  }
  /// Plans from a little after the beginning of a previous plan that is so long.
  Status plan_after(double length) {
    previous_ = straight_on({1.0, 1.0, 1.0}, length);
    ask_from(world_, previous_, 0.01);
    return world_.plan();
  }
  World world_;
  Trajectory previous_;
};

TEST_F(RestBeforeAWall, IsNoReasonToFailWhereItIsBlocked) {
  EXPECT_EQ(plan_after(4.0), Status::kNoPath);
  EXPECT_EQ(world_.report.stage, Stage::kSearch);
  EXPECT_GT(stage(world_, Stage::kPrevious).work, 0u);
  EXPECT_TRUE(world_.report.has_reachable);
  EXPECT_TRUE(world_.trajectory_untouched());
}

TEST_F(RestBeforeAWall, IsTriedAgainWhereItLedToTheGoal) {
  world_.to({5.0, 1.0, 1.0});
  EXPECT_EQ(plan_after(4.0), Status::kNoPath);
  EXPECT_EQ(world_.report.stage, Stage::kSearch);
  EXPECT_GT(stage(world_, Stage::kPrevious).work, 0u);
}

/// In a tunnel in which no voxel is free, the rest of the plan is the only way out. Then a plan leads into another
/// motion.
TEST(RestInATunnel, LeadsOutBeforeTheGoalsOwnEscape) {
  World world({80, 40, 20}, 0.1, 0.19);
  world.block({1.0, 0.0, 0.0}, {3.0, 0.8, 2.0}).block({1.0, 1.2, 0.0}, {3.0, 4.0, 2.0});
  world.from({2.85, 1.0, 1.0}).to({5.0, 1.0, 1.0});
  world.request.start.velocity = {1.0, 0.0, 0.0};
  ASSERT_EQ(world.plan(), Status::kOk);
  const Trajectory first = world.trajectory;
  ask_from(world, first, 0.01);
  world.to({7.0, 3.0, 1.0});
  world.request.goal.velocity = {0.0, 0.5, 0.0};
  ASSERT_EQ(world.replan(), Status::kOk);
  EXPECT_EQ(world.report.diagnostics.detours, tern::detours_of(tern::Attempt::kFollow));
  EXPECT_GT(stage(world, Stage::kPrevious).work, 0u);
  EXPECT_GT(stage(world, Stage::kStopFirst).work, 0u);
  const double end = tern::duration(first) - 0.01;
  EXPECT_LE(tern::distance(tern::evaluate(world.trajectory, end).position, {5.0, 1.0, 1.0}), 1e-9);
  const tern::Segment& last = world.trajectory.segments[world.trajectory.count - 1];
  EXPECT_NEAR((last.points[7].y - last.points[6].y) * 7.0 / last.duration, 0.5, 1e-9);
}

}  // namespace
}  // namespace tern_test
