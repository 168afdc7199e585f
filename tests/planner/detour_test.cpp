// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/detour.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "curve/brake.hpp"
#include "curve/rest.hpp"
#include "support/world.hpp"
#include "trajectory/stop_and_go.hpp"
#include "world/fences.hpp"

namespace tern_test {
namespace {

using tern::Path;
using tern::Request;
using tern::Status;
using tern::Vec3;

/// A corridor along x, 1 m wide, that opens to a room at x = 4.
class Detour : public testing::Test {
 protected:
  Detour() : world_({80, 40, 20}, 0.1, 0.2) {
    world_.block({0.0, 0.0, 0.0}, {4.0, 1.0, 2.0}).block({0.0, 2.0, 0.0}, {4.0, 4.0, 2.0});
    world_.grid.inflate();
    request_.limits = {{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};
    set_path({{1.0, 1.5, 1.0}, {4.2, 1.5, 1.0}, {5.0, 3.5, 1.0}});
  }
  void set_path(std::initializer_list<Vec3> points) {
    path_->count = 0;
    for (const Vec3& point : points) path_->points[path_->count++] = point;
    path_->length = -1.0;
    request_.start.position = path_->points[0];
    request_.goal.position = path_->points[path_->count - 1];
  }
  bool take() { return tern::take_detour(tern::World(world_.grid), request_, request_.limits, *path_, work_); }

  World world_;
  Request request_{};
  std::unique_ptr<Path> path_ = std::make_unique<Path>();
  tern::Work work_;
};

TEST_F(Detour, LeadsPastTheStartsStoppingPoint) {
  set_path({{5.0, 1.0, 1.0}, {4.2, 1.5, 1.0}, {1.0, 1.5, 1.0}});
  request_.start.velocity = {1.0, 0.0, 0.0};
  ASSERT_TRUE(take());
  // 0.5 s at full deceleration, and a ramp's 0.05 s: half of 0.55 m.
  ASSERT_EQ(path_->count, 4);
  EXPECT_NEAR(path_->points[1].x, 5.275, 1e-12);
  EXPECT_EQ(path_->points[1].y, 1.0);
  EXPECT_EQ(path_->points[2].x, 4.2) << "the corridor's end is not in sight from there";
  EXPECT_GT(path_->length, 4.4);
}

TEST_F(Detour, GoesOnToTheFurthestWaypointInSight) {
  set_path({{5.0, 1.5, 1.0}, {5.5, 2.0, 1.0}, {6.0, 1.6, 1.0}, {7.5, 1.5, 1.0}});
  request_.start.velocity = {0.0, 1.0, 0.0};
  ASSERT_TRUE(take());
  ASSERT_EQ(path_->count, 3);
  EXPECT_NEAR(path_->points[1].y, 1.775, 1e-12);
  EXPECT_EQ(path_->points[2].x, 7.5);
}

TEST_F(Detour, GoesBackWhereNothingElseIsInSight) {
  set_path({{3.9, 1.5, 1.0}, {3.0, 1.5, 1.0}, {1.0, 1.5, 1.0}});
  request_.start.velocity = {2.0, 2.0, 0.0};
  ASSERT_TRUE(take());
  ASSERT_EQ(path_->count, 5);
  EXPECT_EQ(path_->points[2].x, 3.9) << "back to the start";
  EXPECT_EQ(path_->points[3].x, 3.0);
  EXPECT_EQ(path_->points[4].x, 1.0);
}

TEST_F(Detour, BrakesSharply) {
  request_.start.velocity = {0.0, 1.0, 0.0};  // 0.3 m to the wall's clearance, 0.25 m at full deceleration
  ASSERT_TRUE(take());
  EXPECT_NEAR(path_->points[1].y, 1.775, 1e-12);
}

TEST_F(Detour, ThereIsNoneWhereTheMotionCannotStop) {
  request_.start.velocity = {0.0, 2.0, 0.0};
  EXPECT_FALSE(take());
  EXPECT_EQ(path_->count, 3);
  EXPECT_EQ(path_->length, -1.0) << "unchanged";
  EXPECT_EQ(path_->points[0].x, 1.0);
}

TEST(DetourFarAway, StopsOnTheBoundaryWhereRoundingLeadsBeyondIt) {
  const World far({18, 8, 8}, 1.0, 0.0, {0.0, 0.0, 6.5e6});  // coordinates round by nanometres
  Path path{};
  path.count = 2;
  path.points[0] = {0.0, 3.0, 3.0};
  path.points[1] = {9.0, 3.0, 3.0};
  Request request{};
  request.start.position = path.points[0];
  request.start.velocity = {-3e-8, 0.0, 0.0};
  request.goal.position = path.points[1];
  request.limits = {{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};
  const tern::MotionLimits limits(request.limits);
  const tern::State& start = request.start;
  ASSERT_LT(tern::stopping_point(tern::make_brake(start, limits, tern::kBrakeShapes - 1)).x, -1e-9);
  tern::Work work;
  ASSERT_TRUE(tern::take_detour(tern::World(far.grid), request, limits, path, work));
  EXPECT_EQ(path.points[1].x, 0.0);
}

TEST_F(Detour, LeadsToTheGoalFromWhereItsMotionCanBegin) {
  request_.goal.velocity = {0.0, 1.0, 0.0};
  ASSERT_TRUE(take());
  ASSERT_EQ(path_->count, 4);
  EXPECT_EQ(path_->points[3].y, 3.5);
  EXPECT_NEAR(path_->points[2].y, 3.5 - 0.275, 1e-12);
}

TEST_F(Detour, KeepsBothEndsStops) {
  set_path({{5.0, 1.5, 1.0}, {7.0, 1.5, 1.0}});
  request_.start.velocity = {0.0, 1.0, 0.0};
  request_.goal.velocity = {0.0, 1.0, 0.0};
  ASSERT_TRUE(take());
  ASSERT_EQ(path_->count, 4);
  EXPECT_NEAR(path_->points[1].y, 1.775, 1e-12);
  EXPECT_NEAR(path_->points[2].y, 1.225, 1e-12);
}

/// The same room with one fence: a keep-out box.
class FencedDetour : public Detour {
 protected:
  FencedDetour() { set_path({{5.0, 1.5, 1.0}, {5.5, 2.0, 1.0}, {6.0, 1.6, 1.0}, {7.5, 1.5, 1.0}}); }
  bool take_within(const tern::Box& box) {
    tern::Halfspace planes[tern::kBoxPlanes];
    tern::box_planes(box, planes);
    const tern::Fence fence{planes, tern::kBoxPlanes, tern::FenceKind::kKeepOut};
    EXPECT_EQ(tern::load_fences(world_.grid, &fence, 1, *solids_).status, Status::kOk);
    return tern::take_detour(tern::World(world_.grid, *solids_), request_, request_.limits, *path_, work_);
  }
  std::unique_ptr<tern::Solids> solids_ = std::make_unique<tern::Solids>();
};

TEST_F(FencedDetour, ThereIsNoneIntoAFence) {
  request_.start.velocity = {0.0, 1.0, 0.0};
  // It stops at y = 1.775 at the earliest, and keeps 0.2 m.
  EXPECT_FALSE(take_within({{4.0, 1.9, 0.0}, {8.0, 4.0, 2.0}}));
  EXPECT_EQ(path_->count, 4);
  EXPECT_EQ(path_->length, -1.0) << "unchanged";
  EXPECT_TRUE(take_within({{4.0, 2.1, 0.0}, {8.0, 4.0, 2.0}}));
}

TEST_F(FencedDetour, GoesOnToTheFurthestWaypointThatFencesLeaveInSight) {
  request_.start.velocity = {0.0, 1.0, 0.0};
  ASSERT_TRUE(take_within({{6.8, 0.0, 0.0}, {7.0, 1.7, 2.0}}));  // across the line to the last waypoint
  ASSERT_EQ(path_->count, 4);
  EXPECT_NEAR(path_->points[1].y, 1.775, 1e-12);
  EXPECT_EQ(path_->points[2].x, 6.0);
  EXPECT_EQ(path_->points[3].x, 7.5);
}

TEST_F(Detour, NeedsRoomForItsWaypoints) {
  path_->count = tern::kMaxWaypoints - 1;
  for (int k = 0; k < path_->count; ++k) path_->points[k] = {5.0, 1.5, 1.0};
  request_.start.velocity = {0.0, 1.0, 0.0};
  EXPECT_FALSE(take());
}

/// Starts into a dead end, away from the only way out: the polyhedron around the path's first leg does not reach there.
World sideways() {
  World world({80, 60, 20}, 0.1, 0.2);
  world.block({1.5, 0.0, 0.0}, {1.7, 2.6, 2.0}).block({1.5, 3.4, 0.0}, {1.7, 6.0, 2.0});
  world.block({0.0, 0.0, 0.0}, {0.9, 2.0, 2.0});
  world.from({1.2, 2.4, 1.0}).to({6.0, 5.0, 1.0});
  world.request.start.velocity = {0.0, -2.0, 0.0};
  return world;
}

TEST(DetourPlan, IsReportedAndBounded) {
  World world = sideways();
  ASSERT_EQ(world.plan(), Status::kOk);
  EXPECT_EQ(world.report.diagnostics.detours, 1);
  EXPECT_EQ(world.planner.path()->points[1].x, 1.2);
  EXPECT_LT(world.planner.path()->points[1].y, 1.4);
  EXPECT_GT(world.report.diagnostics.stages[static_cast<int>(tern::Stage::kDetour)].work, 0u);
  for (const tern::StageReport& stage : world.report.diagnostics.stages) EXPECT_LE(stage.work, stage.bound);
}

TEST(DetourPlan, SlicesGiveTheSameBits) {
  World whole = sideways();
  ASSERT_EQ(whole.plan(), Status::kOk);
  World sliced = sideways();
  sliced.grid.inflate();
  std::memset(static_cast<void*>(&sliced.trajectory), 0x5A, sizeof sliced.trajectory);
  ASSERT_EQ(sliced.planner.begin(sliced.grid, sliced.request), Status::kRunning);
  while (sliced.planner.step(3) == Status::kRunning) {
  }
  ASSERT_EQ(sliced.planner.finish(sliced.trajectory, sliced.report), Status::kOk);
  EXPECT_EQ(std::memcmp(&whole.trajectory, &sliced.trajectory, sizeof whole.trajectory), 0);
}

TEST(DetourPlan, KeepsTheBudgetsOverBothAttempts) {
  World world = sideways();
  ASSERT_EQ(world.plan(), Status::kOk);
  const tern::Report full = world.report;
  world.request.budget.trajectory =
      static_cast<std::uint32_t>(full.diagnostics.stages[static_cast<int>(tern::Stage::kTrajectory)].work / 2);
  ASSERT_EQ(world.replan(), Status::kOk) << "stop-and-go at least";
  const tern::StageReport& optimising = world.report.diagnostics.stages[static_cast<int>(tern::Stage::kTrajectory)];
  EXPECT_LE(optimising.work, optimising.bound);
  world.request.budget.trajectory = 0xFFFFFFFFu;
  world.request.budget.corridor =
      static_cast<std::uint32_t>(full.diagnostics.stages[static_cast<int>(tern::Stage::kCorridor)].work / 2);
  EXPECT_EQ(world.replan(), Status::kNoTrajectory);
  EXPECT_TRUE(world.trajectory_untouched());
}

TEST(DetourPlan, SharesTheBudgetOfTheShortcut) {
  World world = sideways();
  ASSERT_EQ(world.plan(), Status::kOk);
  const auto shortcut =
      static_cast<std::uint32_t>(world.report.diagnostics.stages[static_cast<int>(tern::Stage::kShortcut)].work);
  world.request.budget.shortcut = shortcut + 1;
  ASSERT_EQ(world.replan(), Status::kOk);
  EXPECT_EQ(world.report.diagnostics.detours, 1);
  world.request.budget.shortcut = shortcut - 1;
  world.replan();
  EXPECT_NE(world.report.diagnostics.detours, 1);
  EXPECT_EQ(world.report.diagnostics.stages[static_cast<int>(tern::Stage::kDetour)].work, 0u);
}

TEST(DetourPlan, NoneOnAWayThroughVias) {
  World world = sideways();
  tern::Via via{};
  via.position = {4.0, 5.0, 1.0};
  world.request.vias = &via;
  world.request.via_count = 1;
  ASSERT_EQ(world.plan(), Status::kOk);
  EXPECT_EQ(world.report.diagnostics.detours, 2) << "it comes to rest first";
  EXPECT_EQ(world.report.diagnostics.stages[static_cast<int>(tern::Stage::kDetour)].work, 0u);
}

TEST(DetourPlan, NoneAtRest) {
  World world = sideways();
  world.request.start.velocity = {0.0, 0.0, 0.0};
  ASSERT_EQ(world.plan(), Status::kOk);
  EXPECT_EQ(world.report.diagnostics.detours, 0);
}

}  // namespace
}  // namespace tern_test
