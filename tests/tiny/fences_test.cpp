// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every capacity for geofences overflows in the tiny configuration, each with its own status.
#include <gtest/gtest.h>

#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Fence;
using tern::FenceKind;
using tern::Halfspace;
using tern::Status;

Status plan(World& world, const std::vector<Fence>& fences) {
  world.request.fences = fences.data();
  world.request.fence_count = static_cast<std::int32_t>(fences.size());
  return world.plan();
}

TEST(TinyFences, EachCapacityHasItsStatus) {
  World world({16, 16, 8}, 0.1, 0.0);
  world.from({0.25, 0.25, 0.25}).to({0.85, 0.85, 0.45});
  const std::vector<Halfspace> planes(tern::kMaxFencePlanes + 1, {{1.0, 0.0, 0.0}, 1.5});
  const Fence one{planes.data(), 1, FenceKind::kKeepIn};
  EXPECT_EQ(plan(world, std::vector<Fence>(tern::kMaxFences, one)), Status::kOk);
  EXPECT_EQ(plan(world, std::vector<Fence>(tern::kMaxFences + 1, one)), Status::kFencesFull);
  EXPECT_EQ(plan(world, {{planes.data(), tern::kMaxFencePlanes + 1, FenceKind::kKeepIn}}), Status::kFencePlanesFull);
  EXPECT_EQ(plan(world, {{planes.data(), tern::kMaxFencePlanes, FenceKind::kKeepOut}}), Status::kStartFenced);
  EXPECT_EQ(world.report.field, tern::Field::kStartPosition);
}

TEST(TinyFences, ANarrowGridNeedsMoreWordsThanVoxels) {
  World world({1, 64, 64}, 0.1, 0.0);  // a word a row: 4096 of them
  world.from({0.05, 0.25, 0.25}).to({0.05, 0.85, 0.45});
  const Halfspace far{{0.0, 1.0, 0.0}, 5.0};
  EXPECT_EQ(plan(world, {}), Status::kOk);
  EXPECT_EQ(plan(world, {{&far, 1, FenceKind::kKeepIn}}), Status::kWorldFull);
  EXPECT_EQ(world.report.field, tern::Field::kFences);
  const Halfspace short_of_goal{{0.0, 1.0, 0.0}, 0.5};
  EXPECT_EQ(plan(world, {{&short_of_goal, 1, FenceKind::kKeepIn}}), Status::kGoalFenced);
  EXPECT_EQ(world.report.field, tern::Field::kGoalPosition);
  EXPECT_FALSE(world.report.has_reachable);
}

TEST(TinyFences, AGoalAsNearAsPossibleNeedsALayerToo) {
  World world({1, 64, 64}, 0.1, 0.0);
  world.block({0.0, 0.5, 0.0}, {0.1, 0.6, 6.4}).from({0.05, 0.25, 0.25}).to({0.05, 0.85, 0.45});
  EXPECT_EQ(world.plan(), Status::kNoPath);
  EXPECT_FALSE(world.report.has_reachable);
  world.request.goal_mode = tern::GoalMode::kNearest;
  EXPECT_EQ(world.plan(), Status::kWorldFull);
  EXPECT_EQ(world.report.stage, tern::Stage::kReach);
}

}  // namespace
}  // namespace tern_test
