// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where the path's stages are at the edge of what they tell apart: pockets that meet outside, ends that are one, ways
// that are full, and lines that end as near to a blocked voxel as rounding.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "path/polyline.hpp"
#include "path/reach_stage.hpp"
#include "path/sight.hpp"
#include "support/path_world.hpp"

namespace {

using tern::Path;
using tern::Status;
using tern::Vec3;
using tern::Voxel;
using tern_test::Random;
using tern_test::VoxelWorld;

/// Two voxels that meet in the start's corner, each with a way out of a block. The second is reached from outside
/// before the start joins it.
TEST(PathLimits, APocketThatIsFloodedAlreadyIsNotFloodedAgain) {
  VoxelWorld world({14, 14, 14});
  world.block({1, 1, 1}, {8, 8, 8});
  for (int x = 4; x <= 8; ++x) world.clear({x, 4, 4});
  for (int x = 1; x <= 3; ++x) world.clear({x, 3, 3});
  world.block({10, 10, 10}, {12, 12, 12}).clear({11, 11, 11});
  const auto stage = std::make_unique<tern::ReachStage>();
  tern::reach_begin(*stage, tern::World(world.grid), {{4.0, 4.0, 4.0}, {11.6, 11.5, 11.5}});
  tern::Work work{0xFFFFFFFFu};
  ASSERT_EQ(tern::reach_advance(*stage, tern::World(world.grid), work), tern::Progress::kDone);
  EXPECT_TRUE(stage->start.voxel.x == 3 && stage->start.voxel.y == 3 && stage->start.voxel.z == 3) << "joined last";
  EXPECT_TRUE(stage->nearest.x == 13 && stage->nearest.y == 11 && stage->nearest.z == 11);
}

TEST(PathLimits, AnOccupiedStartThatIsTheGoalIsOccupied) {
  VoxelWorld world({5, 5, 5});
  world.block({2, 2, 2});
  tern_test::PathRunner runner;
  EXPECT_EQ(runner.run(world.grid, Vec3{2.5, 2.5, 2.5}, Vec3{2.5, 2.5, 2.5}), Status::kStartOccupied);
  EXPECT_TRUE(runner.search().raw_occupied);
}

void fill(int raw, int count, Path& part) {
  part.raw_count = raw;
  part.count = count;
  for (int i = 0; i < raw; ++i) part.raw[i] = {1.0 * i, 0.0, 0.0};
  for (int i = 0; i < count; ++i) part.points[i] = {0.0, 1.0 * i, 0.0};
  part.raw_length = 1.0;
  part.grid_length = 2.0;
  part.length = 3.0;
}

TEST(PathLimits, AWayTakesPartsUntilItIsFull) {
  const auto way = std::make_unique<Path>();
  const auto part = std::make_unique<Path>();
  clear_way(*way);
  fill(5, 2, *part);
  ASSERT_EQ(append_to_way(*part, *way), Status::kOk);
  fill(tern::kMaxJumpPoints - 4, tern::kMaxWaypoints - 1, *part);  // the first point of each is the last one's last
  ASSERT_EQ(append_to_way(*part, *way), Status::kOk);
  EXPECT_EQ(way->raw_count, tern::kMaxJumpPoints);
  EXPECT_EQ(way->count, tern::kMaxWaypoints);
  EXPECT_EQ(way->raw[5].x, 1.0);
  EXPECT_EQ(way->points[2].y, 1.0);
  EXPECT_EQ(way->length, 6.0);
  fill(2, 1, *part);
  EXPECT_EQ(append_to_way(*part, *way), Status::kJumpPointsFull);
  fill(1, 2, *part);
  EXPECT_EQ(append_to_way(*part, *way), Status::kSegmentsFull);
  EXPECT_EQ(way->raw_count, tern::kMaxJumpPoints);
  EXPECT_EQ(way->count, tern::kMaxWaypoints);
  EXPECT_EQ(way->length, 6.0);
}

/// Lines that end kSightRounding before a blocked row or layer: whether they count as clear is rounding. A picometre
/// nearer or further it is not.
TEST(PathLimits, LinesThatEndInReachOfAFaceButForRounding) {
  constexpr double kLittle = 1e-12;
  constexpr int kLines = 200;
  Random random(91);
  int clear = 0;
  for (const int axis : {1, 2}) {
    for (const int face : {7, 65}) {
      const int size = face + 2;
      VoxelWorld world({12, axis == 1 ? size : 12, axis == 2 ? size : 12});
      world.block({0, axis == 1 ? face : 0, axis == 2 ? face : 0}, {11, axis == 1 ? face : 11, axis == 2 ? face : 11});
      for (int k = 0; k < kLines; ++k) {
        Vec3 from{random.real(1.0, 11.0), random.real(1.0, 2.9), random.real(1.0, 2.9)};
        Vec3 to{random.real(1.0, 11.0), random.real(1.0, 2.9), random.real(1.0, 2.9)};
        double& first = axis == 1 ? from.y : from.z;
        double& last = axis == 1 ? to.y : to.z;
        first = face - random.real(1.01, 1.9);  // above 64, doubles are half as dense as there
        last = face - tern::kSightRounding - kLittle;
        ASSERT_TRUE(tern::line_of_sight(world.grid, from, to, 0.0)) << face << ' ' << k;
        last = face - tern::kSightRounding + kLittle;
        ASSERT_FALSE(tern::line_of_sight(world.grid, from, to, 0.0)) << face << ' ' << k;
        last = face - tern::kSightRounding;
        for (int units = 0; units < 3; ++units) {
          clear += tern::line_of_sight(world.grid, from, to, 0.0) ? 1 : 0;
          clear += tern::line_of_sight(world.grid, to, from, 0.0) ? 1 : 0;
          last = std::nextafter(last, 0.0);
        }
      }
    }
  }
  EXPECT_GT(clear, 0);
  EXPECT_LT(clear, 6 * 4 * kLines);
}

}  // namespace
