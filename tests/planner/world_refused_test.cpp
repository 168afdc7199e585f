// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Faults of the world: F06 to F08, F10, through the whole planner.
#include <gtest/gtest.h>

#include <cstring>

#include "support/random.hpp"
#include "support/world.hpp"

namespace {

using tern::Status;
using tern_test::World;

TEST(WorldFault, EnclosedGoal) {  // F06
  World world({30, 30, 20}, 0.1, 0.1);
  world.from({0.35, 0.35, 1.05}).to({2.05, 2.05, 1.05});
  for (const double x : {1.6, 2.4}) world.block({x, 1.6, 0.0}, {x + 0.1, 2.5, 2.0});
  for (const double y : {1.6, 2.4}) world.block({1.6, y, 0.0}, {2.5, y + 0.1, 2.0});
  EXPECT_EQ(world.plan(), Status::kNoPath);
  EXPECT_EQ(world.report.stage, tern::Stage::kSearch);
  EXPECT_LE(world.report.diagnostics.stages[1].work, world.report.diagnostics.stages[1].bound);
  EXPECT_TRUE(world.trajectory_untouched());
}

TEST(WorldFault, FullMap) {  // F06
  World world({10, 10, 10}, 0.1, 0.0);
  world.block({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}).from({0.55, 0.55, 0.55}).to({0.15, 0.15, 0.15});
  EXPECT_EQ(world.plan(), Status::kStartOccupied);
  EXPECT_TRUE(world.report.raw_occupied);
  EXPECT_FALSE(world.report.has_nearest_free);
}

TEST(WorldFault, OneCellMap) {  // F06, F07
  World world({1, 1, 1}, 1.0, 0.3);
  world.from({0.2, 0.2, 0.2}).to({0.8, 0.7, 0.6});
  ASSERT_EQ(world.plan(), Status::kOk);
  EXPECT_NEAR(tern::evaluate(world.trajectory, 1e9).position.x, 0.8, 1e-9);
  world.block({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0});
  EXPECT_EQ(world.plan(), Status::kStartOccupied);
}

TEST(WorldFault, StartEqualsGoal) {  // F07
  World world({20, 20, 20}, 0.1, 0.1);
  world.from({1.0, 1.0, 1.0}).to({1.0, 1.0, 1.0});
  ASSERT_EQ(world.plan(), Status::kOk);
  EXPECT_EQ(world.report.quality, tern::Quality::kHover);
  ASSERT_EQ(world.trajectory.count, 1);
  for (const double t : {0.0, 0.5 * tern::duration(world.trajectory), 100.0}) {
    const tern::Sample sample = tern::evaluate(world.trajectory, t);
    EXPECT_DOUBLE_EQ(sample.position.x, 1.0);
    EXPECT_DOUBLE_EQ(sample.velocity.y, 0.0);
  }
}

TEST(WorldFault, StartAndGoalInOneCell) {  // F07
  World world({20, 20, 20}, 0.1, 0.1);
  world.from({1.01, 1.02, 1.03}).to({1.01, 1.02, 1.03 + 1e-12});
  ASSERT_EQ(world.plan(), Status::kOk);
  world.to({1.09, 1.01, 1.02});
  ASSERT_EQ(world.plan(), Status::kOk);
  EXPECT_NEAR(tern::evaluate(world.trajectory, 1e9).position.x, 1.09, 1e-9);
}

TEST(WorldFault, CornersAreNotCut) {  // F08: two columns that touch along an edge leave no way between them
  World world({20, 20, 4}, 0.1, 0.0);
  world.block({0.0, 1.0, 0.0}, {1.0, 1.1, 0.4}).block({1.0, 0.9, 0.0}, {2.0, 1.0, 0.4});
  world.from({0.55, 0.55, 0.15}).to({1.45, 1.45, 0.15});
  EXPECT_EQ(world.plan(), Status::kNoPath);
  EXPECT_TRUE(world.trajectory_untouched());
}

TEST(WorldFault, StraightAlongEachAxis) {  // F08
  const tern::Vec3 ends[] = {{1.75, 0.25, 0.25}, {0.25, 1.75, 0.25}, {0.25, 0.25, 1.75}, {1.75, 1.75, 1.75}};
  for (const tern::Vec3& end : ends) {
    World world({20, 20, 20}, 0.1, 0.1);
    world.from({0.25, 0.25, 0.25}).to(end);
    ASSERT_EQ(world.plan(), Status::kOk);
    ASSERT_NE(world.planner.path(), nullptr);
    EXPECT_EQ(world.planner.path()->count, 2);
    EXPECT_EQ(world.planner.corridor()->count, 1);
  }
}

TEST(WorldFault, OneCellTunnel) {  // F10
  World world({30, 11, 11}, 0.1, 0.0);
  world.block({1.0, 0.0, 0.0}, {2.0, 0.5, 1.1}).block({1.0, 0.6, 0.0}, {2.0, 1.1, 1.1});
  world.block({1.0, 0.5, 0.0}, {2.0, 0.6, 0.5}).block({1.0, 0.5, 0.6}, {2.0, 0.6, 1.1});
  world.from({0.45, 0.25, 0.25}).to({2.65, 0.85, 0.85});
  EXPECT_EQ(world.plan(), Status::kOk);
}

TEST(WorldFault, RadiusThatJustFits) {  // F10: a door exactly two radii and one voxel wide
  World world({30, 20, 10}, 0.1, 0.3);
  world.block({1.4, 0.0, 0.0}, {1.5, 0.6, 1.0}).block({1.4, 1.3, 0.0}, {1.5, 2.0, 1.0});
  world.from({0.45, 0.45, 0.45}).to({2.55, 1.55, 0.45});
  EXPECT_EQ(world.plan(), Status::kOk);
  World narrow({30, 20, 10}, 0.1, 0.35);
  narrow.block({1.4, 0.0, 0.0}, {1.5, 0.6, 1.0}).block({1.4, 1.3, 0.0}, {1.5, 2.0, 1.0});
  narrow.from({0.45, 0.45, 0.45}).to({2.55, 1.55, 0.45});
  EXPECT_EQ(narrow.plan(), Status::kNoPath);
}

/// A start on the corner of touching obstacles is blocked by no stage where the radius counts as none.
TEST(WorldFault, ARadiusOfANanometreIsNone) {  // F10
  tern_test::Random random(10);
  int planned = 0;
  for (int turn = 0; turn < tern_test::scaled(400); ++turn) {
    World none({12, 12, 8}, 0.2, 0.0, {0.3, 0.4, 0.5});
    World nanometre({12, 12, 8}, 0.2, 1e-9, {0.3, 0.4, 0.5});
    for (int k = 0; k < 120; ++k) {
      const tern::Voxel voxel{random.integer(0, 11), random.integer(0, 11), random.integer(0, 7)};
      for (World* world : {&none, &nanometre}) ASSERT_EQ(world->grid.mark_voxel(voxel), Status::kOk);
    }
    const tern::Vec3 corner{0.2 * random.integer(1, 10), 0.2 * random.integer(1, 10), 0.2 * random.integer(1, 6)};
    const tern::Vec3 goal{0.2 * random.integer(1, 10) + 0.1, 0.2 * random.integer(1, 10) + 0.1, 0.7};
    for (World* world : {&none, &nanometre}) world->from(corner).to(goal);
    ASSERT_EQ(nanometre.plan(), none.plan()) << "turn " << turn;
    if (none.report.status != Status::kOk) continue;
    ++planned;
    const std::size_t bytes = sizeof(tern::Segment) * static_cast<std::size_t>(none.trajectory.count);
    ASSERT_EQ(std::memcmp(none.trajectory.segments, nanometre.trajectory.segments, bytes), 0) << "turn " << turn;
  }
  EXPECT_GT(planned, tern_test::scaled(400) / 4);
}

}  // namespace
