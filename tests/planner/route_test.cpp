// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A path alone, and plans that begin at the durations of another one.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "support/world.hpp"

namespace {

using tern::Field;
using tern::Status;
using tern_test::World;

constexpr auto kCorridorIndex = static_cast<int>(tern::Stage::kCorridor);
constexpr auto kTrajectoryIndex = static_cast<int>(tern::Stage::kTrajectory);

World room_with_two_walls() {
  World world({40, 40, 20}, 0.1, 0.15);
  world.block({1.5, 0.0, 0.0}, {1.7, 2.8, 2.0}).block({2.6, 1.2, 0.0}, {2.8, 4.0, 2.0});
  world.from({0.55, 0.55, 1.05}).to({3.45, 3.45, 1.05});
  world.grid.inflate();
  return world;
}

void expect_same_path(const tern::Path& a, const tern::Path& b) {
  ASSERT_EQ(a.count, b.count);
  EXPECT_EQ(std::memcmp(a.points, b.points, sizeof *a.points * static_cast<std::size_t>(a.count)), 0);
  EXPECT_EQ(a.length, b.length);
}

TEST(Route, IsThePathOfThePlan) {
  World planned = room_with_two_walls();
  ASSERT_EQ(planned.replan(), Status::kOk);
  World world = room_with_two_walls();
  ASSERT_EQ(world.planner.route(world.grid, world.request, world.report), Status::kOk);
  expect_same_path(*world.planner.path(), *planned.planner.path());
  EXPECT_EQ(world.planner.corridor(), nullptr);
  EXPECT_EQ(world.report.stage, tern::Stage::kShortcut);
  EXPECT_EQ(world.report.quality, tern::Quality::kNone);
  EXPECT_EQ(world.report.diagnostics.search_bound, planned.report.diagnostics.search_bound);
  EXPECT_EQ(world.report.diagnostics.stages[kCorridorIndex].bound, 0u);
}

TEST(Route, HasTheSameBitsInSlices) {
  World whole = room_with_two_walls();
  ASSERT_EQ(whole.planner.route(whole.grid, whole.request, whole.report), Status::kOk);
  World sliced = room_with_two_walls();
  Status status = sliced.planner.begin_route(sliced.grid, sliced.request);
  EXPECT_EQ(sliced.planner.path(), nullptr);
  while (status == Status::kRunning) status = sliced.planner.step(1);
  EXPECT_EQ(sliced.planner.finish_route(sliced.report), Status::kOk);
  expect_same_path(*sliced.planner.path(), *whole.planner.path());
}

TEST(Route, PassesVias) {
  World world = room_with_two_walls();
  tern::Via via{};
  via.position = {0.55, 3.45, 1.05};
  world.request.vias = &via;
  world.request.via_count = 1;
  ASSERT_EQ(world.planner.route(world.grid, world.request, world.report), Status::kOk);
  const tern::Path& path = *world.planner.path();
  bool passed = false;
  for (int k = 1; k + 1 < path.count; ++k) {
    passed = passed || std::memcmp(path.points + k, &via.position, sizeof via.position) == 0;
  }
  EXPECT_TRUE(passed);
}

TEST(Route, IgnoresMotionAndThePreviousPlan) {
  World world = room_with_two_walls();
  ASSERT_EQ(world.planner.route(world.grid, world.request, world.report), Status::kOk);
  const tern::Path still = *world.planner.path();
  const tern::Trajectory none{};
  world.request.start.velocity = {std::numeric_limits<double>::quiet_NaN(), 100.0, 0.0};
  world.request.previous = &none;
  ASSERT_EQ(world.planner.route(world.grid, world.request, world.report), Status::kOk);
  expect_same_path(*world.planner.path(), still);
}

TEST(Route, SaysHowNearItCanCome) {
  World world = room_with_two_walls();
  world.block({3.0, 1.0, 0.0}, {3.2, 4.0, 2.0}).block({3.0, 1.0, 0.0}, {4.0, 1.2, 2.0});
  world.grid.inflate();
  ASSERT_EQ(world.planner.route(world.grid, world.request, world.report), Status::kNoPath);
  EXPECT_EQ(world.planner.path(), nullptr);
  ASSERT_TRUE(world.report.has_reachable);
  world.request.goal_mode = tern::GoalMode::kNearest;
  ASSERT_EQ(world.planner.route(world.grid, world.request, world.report), Status::kOk);
  EXPECT_EQ(world.report.goal_missed, Status::kNoPath);
  const tern::Path& path = *world.planner.path();
  EXPECT_NEAR(path.points[path.count - 1].x, world.report.reachable.x, 1e-9);
}

TEST(Route, EndsOnlyWithItsOwnCall) {
  World world = room_with_two_walls();
  ASSERT_EQ(world.planner.route(world.grid, world.request, world.report), Status::kOk);
  std::memset(static_cast<void*>(&world.trajectory), 0x5A, sizeof world.trajectory);
  ASSERT_EQ(world.planner.begin_route(world.grid, world.request), Status::kRunning);
  EXPECT_EQ(world.planner.finish_route(world.report), Status::kInvalidArgument);  // too early
  EXPECT_EQ(world.report.field, Field::kCallOrder);
  ASSERT_EQ(world.planner.begin_route(world.grid, world.request), Status::kRunning);
  ASSERT_EQ(world.planner.step(0xFFFFFFFFu), Status::kOk);
  EXPECT_EQ(world.planner.finish(world.trajectory, world.report), Status::kInvalidArgument);
  EXPECT_EQ(world.report.field, Field::kCallOrder);
  EXPECT_TRUE(world.trajectory_untouched());
  ASSERT_EQ(world.planner.begin(world.grid, world.request), Status::kRunning);
  ASSERT_EQ(world.planner.step(0xFFFFFFFFu), Status::kOk);
  EXPECT_EQ(world.planner.finish_route(world.report), Status::kInvalidArgument);
  EXPECT_EQ(world.planner.finish_route(world.report), Status::kInvalidArgument);  // nothing was begun
  EXPECT_EQ(world.report.field, Field::kCallOrder);
  tern::Planner none(nullptr, 0);
  EXPECT_EQ(none.route(world.grid, world.request, world.report), Status::kInvalidArgument);
  EXPECT_EQ(world.report.field, Field::kWorkspace);
}

/// Plans from states on a plan, as a flight makes them: each with the pace of that plan, and without it.
TEST(Pace, SavesIterations) {
  World world = room_with_two_walls();
  ASSERT_EQ(world.replan(), Status::kOk);
  const tern::Trajectory first = world.trajectory;
  const double duration = tern::duration(first);
  std::uint32_t paced = 0;
  std::uint32_t unpaced = 0;
  for (double t = 0.1 * duration; t < 0.8 * duration; t += 0.1 * duration) {
    const tern::Sample now = tern::evaluate(first, t);
    world.request.start = {now.position, now.velocity, now.acceleration, now.jerk};
    ASSERT_EQ(world.replan(), Status::kOk);
    unpaced += world.report.diagnostics.stages[kTrajectoryIndex].work;
    ASSERT_EQ(world.planner.begin(world.grid, world.request, first, t), Status::kRunning);
    ASSERT_EQ(world.planner.step(0xFFFFFFFFu), Status::kOk);
    ASSERT_EQ(world.planner.finish(world.trajectory, world.report), Status::kOk);
    EXPECT_LT(world.report.diagnostics.detours, 3) << "it does not follow the pace";
    paced += world.report.diagnostics.stages[kTrajectoryIndex].work;
  }
  EXPECT_LT(paced, unpaced);
}

/// Asks for a plan that is better than the rest of this one; kOk if there is one.
Status ask_for_better(World& world, const tern::Trajectory& rival, double from) {
  std::memset(static_cast<void*>(&world.trajectory), 0x5A, sizeof world.trajectory);
  EXPECT_EQ(world.planner.begin(world.grid, world.request, rival, from, true), Status::kRunning);
  world.planner.step(0xFFFFFFFFu);
  return world.planner.finish(world.trajectory, world.report);
}

TEST(Pace, OfTheBestPlanEndsTheSearchForABetterOneSoon) {
  World world = room_with_two_walls();
  ASSERT_EQ(world.replan(), Status::kOk);
  const tern::Trajectory first = world.trajectory;
  const std::uint32_t whole = world.report.diagnostics.stages[kTrajectoryIndex].work;
  for (const double part : {0.0, 0.2, 0.4, 0.6}) {
    const tern::Sample now = tern::evaluate(first, part * tern::duration(first));
    world.request.start = {now.position, now.velocity, now.acceleration, now.jerk};
    ASSERT_EQ(ask_for_better(world, first, part * tern::duration(first)), Status::kNoTrajectory) << part;
    EXPECT_EQ(world.report.stage, tern::Stage::kTrajectory);
    EXPECT_TRUE(world.trajectory_untouched());
    EXPECT_LT(3 * world.report.diagnostics.stages[kTrajectoryIndex].work, whole);
  }
}

TEST(Pace, OfASlowPlanIsBeaten) {
  World world = room_with_two_walls();
  const tern::Limits limits = world.request.limits;
  world.request.limits.v_max = {1.0, 1.0, 1.0};
  ASSERT_EQ(world.replan(), Status::kOk);
  const tern::Trajectory slow = world.trajectory;
  world.request.limits = limits;
  ASSERT_EQ(ask_for_better(world, slow, 0.0), Status::kOk);
  EXPECT_LT(tern::duration(world.trajectory), 0.95 * tern::duration(slow));
}

TEST(Pace, IsNoRivalOfAPlanWithDwells) {
  World world = room_with_two_walls();
  tern::Via via{};
  via.position = {2.15, 2.0, 1.05};
  via.stop = true;
  via.dwell = 3.0;
  world.request.vias = &via;
  world.request.via_count = 1;
  ASSERT_EQ(world.replan(), Status::kOk);
  const tern::Trajectory best = world.trajectory;
  EXPECT_EQ(ask_for_better(world, best, 0.0), Status::kOk);
}

TEST(Pace, OfAPlanElsewhereIsNoRival) {
  World world = room_with_two_walls();
  ASSERT_EQ(world.replan(), Status::kOk);
  const tern::Trajectory alone = world.trajectory;
  tern::Trajectory elsewhere = alone;
  elsewhere.origin.z += 1.6;
  ASSERT_EQ(ask_for_better(world, elsewhere, 0.0), Status::kOk);
  ASSERT_EQ(world.trajectory.count, alone.count);
  for (int i = 0; i < alone.count; ++i) {
    EXPECT_EQ(world.trajectory.segments[i].duration, alone.segments[i].duration);
    EXPECT_EQ(
        std::memcmp(world.trajectory.segments[i].points, alone.segments[i].points, sizeof alone.segments[i].points), 0);
  }
}

TEST(Pace, IsRefusedIfItIsNoPlan) {
  World world = room_with_two_walls();
  ASSERT_EQ(world.replan(), Status::kOk);
  const tern::Trajectory plan = world.trajectory;
  const auto answer = [&](const tern::Trajectory& pace, double time) {
    const Status begun = world.planner.begin(world.grid, world.request, pace, time);
    if (begun == Status::kRunning) return begun;
    EXPECT_EQ(world.planner.finish(world.trajectory, world.report), begun);
    EXPECT_EQ(world.report.field, Field::kPrevious);
    return begun;
  };
  EXPECT_EQ(answer(tern::Trajectory{}, 0.0), Status::kInvalidArgument);
  EXPECT_EQ(answer(plan, -1.0), Status::kInvalidArgument);
  EXPECT_EQ(answer(plan, std::numeric_limits<double>::infinity()), Status::kInvalidArgument);
  world.request.previous = &plan;
  world.request.start = {tern::evaluate(plan, 0.0).position, {}, {}};
  EXPECT_EQ(answer(plan, 0.0), Status::kInvalidArgument);
  world.request.previous = nullptr;
  EXPECT_EQ(answer(plan, 0.0), Status::kRunning);
  tern::Planner none(nullptr, 0);
  EXPECT_EQ(none.begin(world.grid, world.request, plan, 0.0), Status::kInvalidArgument);
}

}  // namespace
