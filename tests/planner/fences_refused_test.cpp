// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Requests with geofences that are wrong, in the way, or let nothing through.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Fence;
using tern::FenceKind;
using tern::Field;
using tern::Halfspace;
using tern::Status;

class FencesFault : public ::testing::Test {
 protected:
  FencesFault() { world_.from({0.5, 2.0, 1.0}).to({3.5, 2.0, 1.0}); }

  Status plan(const std::vector<Fence>& fences) {
    world_.request.fences = fences.data();
    world_.request.fence_count = static_cast<std::int32_t>(fences.size());
    return world_.plan();
  }

  World world_{{40, 40, 20}, 0.1, 0.2};
  const Halfspace left_{{1.0, 0.0, 0.0}, 1.0};     // x <= 1
  const Halfspace right_{{-1.0, 0.0, 0.0}, -3.0};  // x >= 3
};

TEST_F(FencesFault, AStartOutsideAKeepInIsItsOwnStatus) {
  EXPECT_EQ(plan({{&right_, 1, FenceKind::kKeepIn}}), Status::kStartFenced);
  EXPECT_EQ(world_.report.field, Field::kStartPosition);
  EXPECT_EQ(world_.report.stage, tern::Stage::kRequest);
  EXPECT_TRUE(world_.trajectory_untouched());
}

TEST_F(FencesFault, AGoalOutsideAKeepInToo) {
  EXPECT_EQ(plan({{&left_, 1, FenceKind::kKeepIn}}), Status::kGoalFenced);
  EXPECT_EQ(world_.report.field, Field::kGoalPosition);
}

TEST_F(FencesFault, InsideAKeepOutToo) {
  EXPECT_EQ(plan({{&left_, 1, FenceKind::kKeepOut}}), Status::kStartFenced);
  EXPECT_EQ(plan({{&right_, 1, FenceKind::kKeepOut}}), Status::kGoalFenced);
}

TEST_F(FencesFault, TheReportNamesTheFenceThatIsBroken) {
  const Halfspace far{{0.0, 0.0, 1.0}, 9.0};  // z <= 9: all of the map
  const Fence anywhere{&far, 1, FenceKind::kKeepIn};
  const Fence nowhere_near{&right_, 1, FenceKind::kKeepOut};
  EXPECT_EQ(plan({anywhere, {&left_, 1, FenceKind::kKeepOut}, nowhere_near}), Status::kStartFenced);
  EXPECT_EQ(world_.report.fence, 1);
  EXPECT_EQ(plan({nowhere_near, anywhere, anywhere}), Status::kGoalFenced);
  EXPECT_EQ(world_.report.fence, 0);
  // Keep-ins are looked at first.
  EXPECT_EQ(plan({{&left_, 1, FenceKind::kKeepOut}, anywhere, {&right_, 1, FenceKind::kKeepIn}}), Status::kStartFenced);
  EXPECT_EQ(world_.report.fence, 2);
  EXPECT_EQ(plan({anywhere}), Status::kOk);
  EXPECT_EQ(world_.report.fence, tern::kNoFence);
  EXPECT_EQ(plan({}), Status::kOk);
  EXPECT_EQ(world_.report.fence, tern::kNoFence);
}

TEST_F(FencesFault, NearerThanTheRadiusToAKeepOutToo) {
  world_.from({1.19, 2.0, 1.0}).to({2.5, 2.0, 1.0});
  EXPECT_EQ(plan({{&left_, 1, FenceKind::kKeepOut}}), Status::kStartFenced);
  world_.from({1.2, 2.0, 1.0});
  EXPECT_EQ(plan({{&left_, 1, FenceKind::kKeepOut}}), Status::kOk) << "exactly at the radius";
}

TEST_F(FencesFault, StartOnTheFaceOfAKeepIn) {
  world_.from({3.0, 2.0, 1.0});
  EXPECT_EQ(plan({{&right_, 1, FenceKind::kKeepIn}}), Status::kOk);
}

TEST_F(FencesFault, AWallOfAFenceLeavesNoPath) {
  const Halfspace wall[] = {{{1.0, 0.0, 0.0}, 2.1}, {{-1.0, 0.0, 0.0}, -1.9}};
  EXPECT_EQ(plan({{wall, 2, FenceKind::kKeepOut}}), Status::kNoPath);
  EXPECT_TRUE(world_.trajectory_untouched());
}

TEST_F(FencesFault, AFenceInTheWayIsFlownAround) {
  Halfspace pillar[tern::kBoxPlanes];
  box_planes({{1.8, 1.5, 0.0}, {2.2, 2.6, 2.0}}, pillar);
  ASSERT_EQ(plan({{pillar, 6, FenceKind::kKeepOut}}), Status::kOk);
  EXPECT_GT(world_.trajectory.count, 1);
  const tern::StageReport& fences = world_.report.diagnostics.stages[static_cast<int>(tern::Stage::kWorld)];
  EXPECT_GT(fences.work, 0u);
  EXPECT_LE(fences.work, fences.bound);
}

/// Thin fences through the start's own voxel: to the voxels beyond them no line leads.
TEST(FencesInAVoxel, ShutAStartInOrLeadItToOneSide) {
  World world({20, 20, 10}, 0.1, 0.0);
  world.from({0.55, 1.05, 0.55}).to({1.55, 1.05, 0.55});
  const Halfspace before[] = {{{1.0, 0.0, 0.0}, 0.52}, {{-1.0, 0.0, 0.0}, -0.51}};
  const Halfspace behind[] = {{{1.0, 0.0, 0.0}, 0.59}, {{-1.0, 0.0, 0.0}, -0.58}};
  const Fence fences[] = {{before, 2, FenceKind::kKeepOut}, {behind, 2, FenceKind::kKeepOut}};
  world.request.fences = fences;
  world.request.fence_count = 2;
  EXPECT_EQ(world.plan(), Status::kStartTooNarrow);
  EXPECT_FALSE(world.report.raw_occupied);
  EXPECT_EQ(world.report.fence, 0);
  EXPECT_EQ(world.report.finer_cell, 0.025);
  EXPECT_TRUE(world.report.has_nearest_free);
  world.request.fence_count = 1;
  ASSERT_EQ(world.plan(), Status::kOk);
  for (int k = 0; k <= 1000; ++k) {
    const double t = tern::duration(world.trajectory) * k / 1000;
    EXPECT_GE(tern::evaluate(world.trajectory, t).position.x, 0.52 - 1e-9) << k;
  }
}

TEST_F(FencesFault, RefusalsNameTheFences) {
  const Halfspace bad{{0.0, 0.0, 0.0}, 1.0};
  const Halfspace nan{{std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}, 1.0};
  EXPECT_EQ(plan({{&bad, 1, FenceKind::kKeepIn}}), Status::kInvalidArgument);
  EXPECT_EQ(world_.report.field, Field::kFences);
  EXPECT_EQ(plan({{&nan, 1, FenceKind::kKeepIn}}), Status::kNonFiniteInput);
  EXPECT_EQ(world_.report.field, Field::kFences);
}

using Planes = std::vector<Halfspace>;

Planes reversed(Planes planes) {
  for (Halfspace& h : planes) h = {{-h.normal.x, -h.normal.y, -h.normal.z}, -h.offset};
  return planes;
}

Planes box(const tern::Box& of) {
  Halfspace planes[tern::kBoxPlanes];
  box_planes(of, planes);
  return {planes, planes + tern::kBoxPlanes};
}

Fence fence_of(const Planes& planes, FenceKind kind) {
  return {planes.data(), static_cast<std::int32_t>(planes.size()), kind};
}

TEST_F(FencesFault, EmptyFencesAreRefusedByTheirIndex) {
  const Planes pillar = box({{1.8, 2.5, 0.0}, {2.2, 2.6, 2.0}});
  const Planes triangle{{{0.0, -1.0, 0.0}, -1.5}, {{1.0, 1.0, 0.0}, 5.0}, {{-1.0, 1.0, 0.0}, 1.0}};
  // A reversed box, a polygon the wrong way round, and two half-spaces that show away from each other.
  for (const Planes& bad : {reversed(pillar), reversed(triangle), Planes{left_, right_}}) {
    for (const FenceKind kind : {FenceKind::kKeepIn, FenceKind::kKeepOut}) {
      EXPECT_EQ(plan({fence_of(pillar, FenceKind::kKeepOut), fence_of(bad, kind)}), Status::kFenceEmpty);
      EXPECT_EQ(world_.report.stage, tern::Stage::kRequest);
      EXPECT_EQ(world_.report.field, Field::kFences);
      EXPECT_EQ(world_.report.fence, 1);
      EXPECT_TRUE(world_.trajectory_untouched());
    }
  }
  EXPECT_EQ(plan({fence_of(pillar, FenceKind::kKeepOut)}), Status::kOk);
  EXPECT_EQ(world_.report.fence, tern::kNoFence);
}

TEST_F(FencesFault, OfKeepInsTheFirstThatLeavesNoPointIsNamed) {
  const Halfspace far{{0.0, 0.0, 1.0}, 9.0};
  const Fence anywhere{&far, 1, FenceKind::kKeepIn};
  const Fence left{&left_, 1, FenceKind::kKeepIn};
  const Fence right{&right_, 1, FenceKind::kKeepIn};
  EXPECT_EQ(plan({left, anywhere, right, anywhere}), Status::kFenceEmpty);
  EXPECT_EQ(world_.report.fence, 2);
  const Planes none{left_, right_};
  EXPECT_EQ(plan({fence_of(none, FenceKind::kKeepOut), left, right}), Status::kFenceEmpty);
  EXPECT_EQ(world_.report.fence, 2) << "keep-ins are looked at first";
  EXPECT_EQ(plan({left, {&right_, 1, FenceKind::kKeepOut}}), Status::kGoalFenced) << "keep-outs need not meet keep-ins";
}

/// One wrong sign may leave a region somewhere else: a fence, if not the one that was meant.
TEST_F(FencesFault, FarAndUnboundedFencesAreNotEmpty) {
  Planes elsewhere = box({{1.8, 1.5, 0.0}, {2.2, 2.6, 2.0}});
  elsewhere[1] = reversed({elsewhere[1]})[0];  // x <= 1.8 in place of x >= 1.8
  EXPECT_EQ(plan({fence_of(elsewhere, FenceKind::kKeepOut)}), Status::kStartFenced);
  elsewhere[1].offset = -1.8;
  EXPECT_EQ(plan({fence_of(elsewhere, FenceKind::kKeepOut)}), Status::kOk);
  for (const double far : {9.0, 1e9, 1e19}) {
    EXPECT_EQ(plan({fence_of({{{-1.0, 0.0, 0.0}, -far}}, FenceKind::kKeepOut)}), Status::kOk) << far;
    EXPECT_EQ(plan({fence_of(box({{far, far, far}, {2.0 * far, far, 3.0 * far}}), FenceKind::kKeepOut)}), Status::kOk)
        << far;
  }
}

TEST_F(FencesFault, AWallWithoutThicknessIsNotEmpty) {
  EXPECT_EQ(plan({fence_of(box({{2.0, 0.0, 0.0}, {2.0, 4.0, 2.0}}), FenceKind::kKeepOut)}), Status::kNoPath);
  EXPECT_EQ(plan({fence_of(box({{2.0, 2.0, 1.0}, {2.0, 2.0, 1.0}}), FenceKind::kKeepOut)}), Status::kOk);
  EXPECT_GT(world_.trajectory.count, 1) << "around a point";
  EXPECT_NE(plan({fence_of(box({{0.0, 0.0, 1.0}, {4.0, 4.0, 1.0}}), FenceKind::kKeepIn)}), Status::kFenceEmpty);
}

TEST_F(FencesFault, TheNextRequestIsFreeOfThem) {
  const Halfspace wall[] = {{{1.0, 0.0, 0.0}, 2.1}, {{-1.0, 0.0, 0.0}, -1.9}};
  EXPECT_EQ(plan({{wall, 2, FenceKind::kKeepOut}}), Status::kNoPath);
  EXPECT_EQ(plan({}), Status::kOk);
}

TEST_F(FencesFault, SlicesGiveTheSameBits) {
  Halfspace pillar[tern::kBoxPlanes];
  box_planes({{1.8, 1.5, 0.0}, {2.2, 2.6, 2.0}}, pillar);
  const Halfspace ceiling{{0.1, 0.0, 1.0}, 1.9};
  ASSERT_EQ(plan({{pillar, 6, FenceKind::kKeepOut}, {&ceiling, 1, FenceKind::kKeepIn}}), Status::kOk);
  EXPECT_GT(world_.report.diagnostics.stages[static_cast<int>(tern::Stage::kWorld)].work, 0u);
  const tern::Trajectory whole = world_.trajectory;
  const std::vector<Fence> fences{{pillar, 6, FenceKind::kKeepOut}, {&ceiling, 1, FenceKind::kKeepIn}};
  world_.request.fences = fences.data();
  ASSERT_EQ(world_.planner.begin(world_.grid, world_.request), Status::kRunning);
  for (int i = 0; i < 1000000 && world_.planner.step(1) == Status::kRunning; ++i) continue;
  ASSERT_EQ(world_.planner.finish(world_.trajectory, world_.report), Status::kOk);
  ASSERT_EQ(world_.trajectory.count, whole.count);
  const std::size_t bytes = sizeof(tern::Segment) * static_cast<std::size_t>(whole.count);
  EXPECT_EQ(std::memcmp(world_.trajectory.segments, whole.segments, bytes), 0);
}

}  // namespace
}  // namespace tern_test
