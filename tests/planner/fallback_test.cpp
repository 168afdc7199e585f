// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A plan that the check refuses falls back on stop-and-go. No request is known to bring that about: the tests spoil the
// plan in the workspace between two slices.
#include <gtest/gtest.h>

#include <cstring>

#include "planner/attempts.hpp"
#include "planner/layout.hpp"
#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Layout;
using tern::Quality;
using tern::Status;

class Fallback : public testing::Test {
 protected:
  Fallback() : world_({60, 40, 20}, 0.1, 0.2) {
    world_.block({2.9, 0.0, 0.0}, {3.1, 2.6, 2.0}).from({1.0, 1.0, 1.0}).to({5.0, 1.0, 1.0});
    world_.grid.inflate();
  }
  Layout& layout() {
    const auto address = reinterpret_cast<std::uintptr_t>(world_.memory.get());
    const std::uintptr_t mask = tern::kWorkspaceAlignment - 1;
    return *reinterpret_cast<Layout*>((address + mask) & ~mask);
  }
  /// Steps until the trajectory is written, which the check then looks at in the next slices.
  Status step_to_trajectory() {
    layout().trajectory.count = -1;
    Status status = Status::kRunning;
    while (status == Status::kRunning && layout().trajectory.count == -1) {
      tern::Work one_piece = tern::Work{1}.within(1);
      status = world_.planner.step(one_piece);
    }
    return status;
  }
  void spoil() { layout().trajectory.segments[0].points[4].z += 100.0; }
  /// What spoil() leads to.
  void expect_found() const {
    const tern::ProofReport& found = world_.report.check;
    EXPECT_EQ(found.finding, tern::Finding::kAcceleration);  // it comes before the curve leaves the boundary
    EXPECT_EQ(found.segment, 0);
    EXPECT_EQ(found.derivative, 2);
    EXPECT_EQ(found.axis, 2);
    EXPECT_GT(found.excess, 1.0);
  }
  Status run() {
    Status status = Status::kRunning;
    while (status == Status::kRunning) status = world_.planner.step(1);
    return world_.planner.finish(world_.trajectory, world_.report);
  }
  void begin() {
    std::memset(static_cast<void*>(&world_.trajectory), 0x5A, sizeof world_.trajectory);
    ASSERT_EQ(world_.planner.begin(world_.grid, world_.request), Status::kRunning);
    ASSERT_EQ(step_to_trajectory(), Status::kRunning);
  }

  World world_;
};

TEST_F(Fallback, UnspoiltPlansAreOptimised) {
  begin();
  ASSERT_EQ(run(), Status::kOk);
  EXPECT_EQ(world_.report.quality, Quality::kOptimised);
  EXPECT_EQ(world_.report.optimiser, Status::kOk);
  EXPECT_EQ(world_.report.check.finding, tern::Finding::kNone);
}

TEST_F(Fallback, FliesFromStopToStopWhatTheCheckRefused) {
  world_.request.budget.trajectory = 0;
  ASSERT_EQ(world_.replan(), Status::kOk);
  const tern::Trajectory stops = world_.trajectory;
  world_.request.budget.trajectory = 0xFFFFFFFFu;
  begin();
  spoil();
  ASSERT_EQ(run(), Status::kOk);
  EXPECT_EQ(world_.report.quality, Quality::kStopAndGo);
  EXPECT_EQ(world_.report.optimiser, Status::kCheckFailed);
  expect_found();
  for (const tern::StageReport& stage : world_.report.diagnostics.stages) EXPECT_LE(stage.work, stage.bound);
  // The very plan that no iteration at all leads to.
  ASSERT_EQ(world_.trajectory.count, stops.count);
  for (int i = 0; i < stops.count; ++i) {
    EXPECT_EQ(world_.trajectory.segments[i].duration, stops.segments[i].duration);
    EXPECT_EQ(
        std::memcmp(world_.trajectory.segments[i].points, stops.segments[i].points, sizeof stops.segments[i].points),
        0);
  }
}

TEST_F(Fallback, EndsWhereStopAndGoIsRefusedAsWell) {
  begin();
  spoil();
  ASSERT_EQ(step_to_trajectory(), Status::kRunning);
  spoil();
  EXPECT_EQ(run(), Status::kCheckFailed);
  EXPECT_EQ(world_.report.stage, tern::Stage::kCheck);
  expect_found();
  EXPECT_EQ(world_.report.quality, Quality::kNone);
  EXPECT_TRUE(world_.trajectory_untouched());
}

TEST_F(Fallback, ThereIsNoneBelowStopAndGo) {
  world_.request.budget.trajectory = 0;
  begin();
  spoil();
  EXPECT_EQ(run(), Status::kCheckFailed);
  EXPECT_TRUE(world_.trajectory_untouched());
}

/// From a tunnel in which no voxel is free, the plan comes to rest outside first. A plan from there is not replaced by
/// stop-and-go but by one from another place of rest.
class EscapedFallback : public Fallback {
 protected:
  EscapedFallback() {
    world_.block({0.0, 0.0, 0.0}, {1.0, 0.8, 2.0}).block({0.0, 1.2, 0.0}, {1.0, 4.0, 2.0});
    world_.grid.inflate();
    world_.from({0.9, 1.0, 1.0}).to({2.0, 3.0, 1.0});
    world_.request.start.velocity = {1.0, 0.0, 0.0};
  }
};

TEST_F(EscapedFallback, ComesToRestElsewhere) {
  begin();
  ASSERT_EQ(run(), Status::kOk);
  ASSERT_EQ(world_.report.quality, Quality::kOptimised);
  ASSERT_EQ(world_.report.diagnostics.detours, tern::detours_of(tern::Attempt::kStopFirst));
  const std::uint32_t stopped = world_.report.diagnostics.stages[static_cast<int>(tern::Stage::kStopFirst)].work;
  begin();
  spoil();
  ASSERT_EQ(run(), Status::kOk);
  EXPECT_EQ(world_.report.quality, Quality::kOptimised);
  EXPECT_EQ(world_.report.diagnostics.detours, tern::detours_of(tern::Attempt::kStopFirst));
  EXPECT_GT(world_.report.diagnostics.stages[static_cast<int>(tern::Stage::kStopFirst)].work, stopped);
}

TEST_F(EscapedFallback, EndsAsTheRequestDidWhereNoneHolds) {
  begin();
  spoil();
  while (step_to_trajectory() == Status::kRunning) spoil();
  EXPECT_EQ(run(), Status::kStartTooNarrow);
  EXPECT_TRUE(world_.trajectory_untouched());
}

TEST_F(Fallback, TheNextPlanBeginsAfresh) {
  begin();
  spoil();
  ASSERT_EQ(run(), Status::kOk);
  ASSERT_EQ(world_.replan(), Status::kOk);
  EXPECT_EQ(world_.report.quality, Quality::kOptimised);
  EXPECT_EQ(world_.report.optimiser, Status::kOk);
  EXPECT_EQ(world_.report.check.finding, tern::Finding::kNone);
}

TEST_F(Fallback, AWrongCorridorChangesNoVerdict) {
  begin();
  tern::Polyhedron& polyhedron = layout().corridor.polyhedra[0];
  polyhedron.count = 1;
  polyhedron.planes[0] = {{1.0, 0.0, 0.0}, 2.8};
  ASSERT_EQ(run(), Status::kOk);
  EXPECT_EQ(world_.report.quality, Quality::kOptimised);
}

}  // namespace
}  // namespace tern_test
