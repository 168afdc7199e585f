// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Exact ends, occupied ends, degenerate maps and budgets of the search and shortcut stages.
#include <gtest/gtest.h>

#include <cmath>

#include "grid/distance.hpp"
#include "support/path_world.hpp"

namespace {

using tern::Path;
using tern::Status;
using tern::Vec3;
using tern::Voxel;
using tern_test::PathQuery;
using tern_test::PathRunner;
using tern_test::Random;
using tern_test::random_ends;
using tern_test::random_free;
using tern_test::random_world;
using tern_test::scaled;
using tern_test::VoxelWorld;

void expect_point(const Vec3& p, const Vec3& q) {
  EXPECT_EQ(p.x, q.x);
  EXPECT_EQ(p.y, q.y);
  EXPECT_EQ(p.z, q.z);
}

TEST(PathEnds, StartEqualsGoal) {
  VoxelWorld world({4, 4, 4});
  PathRunner runner;
  const Vec3 p{1.25, 1.5, 3.0};
  ASSERT_EQ(runner.run(world.grid, p, p), Status::kOk);
  EXPECT_EQ(runner.path().count, 2);
  EXPECT_EQ(runner.path().length, 0.0);
  EXPECT_EQ(runner.path().grid_length, 0.0);
  expect_point(runner.path().points[0], p);
  expect_point(runner.path().points[1], p);
}

TEST(PathEnds, BothInOneVoxel) {
  VoxelWorld world({4, 4, 4});
  world.block({2, 1, 1});
  PathRunner runner;
  // Both closer to the blocked voxel than the margin of sight: inside one free voxel a straight line is safe.
  ASSERT_EQ(runner.run(world.grid, Vec3{1.99, 1.2, 1.2}, Vec3{1.99, 1.8, 1.8}), Status::kOk);
  EXPECT_EQ(runner.path().count, 2);
}

TEST(PathEnds, ExactEndsAreKept) {
  VoxelWorld world({9, 9, 9});
  PathRunner runner;
  ASSERT_EQ(runner.run(world.grid, Vec3{0.1, 0.2, 0.3}, Vec3{9.0, 9.0, 9.0}), Status::kOk);
  // The upper corner of the map belongs to the last voxel, and its margin of sight lies outside: through the centre.
  const Path& path = runner.path();
  expect_point(path.points[0], {0.1, 0.2, 0.3});
  expect_point(path.points[path.count - 1], {9.0, 9.0, 9.0});
  ASSERT_EQ(path.count, 3);
  expect_point(path.points[1], {8.5, 8.5, 8.5});
}

TEST(PathEnds, NearABlockedVoxelOnlyTheOwnCentreIsVisible) {
  VoxelWorld world({9, 5, 5});
  world.block({1, 1, 2});
  PathRunner runner;
  ASSERT_EQ(runner.run(world.grid, Vec3{2.01, 1.5, 2.5}, Vec3{7.5, 3.5, 2.5}), Status::kOk);
  ASSERT_EQ(runner.path().count, 3);
  expect_point(runner.path().points[1], {2.5, 1.5, 2.5});
}

TEST(PathEnds, BlockedVoxelWithAClearPointIsServed) {
  // A wall up to x = 1 and radius 0.3: voxel 1 is not free, but every point of it from x = 1.3 on keeps the radius.
  VoxelWorld world({8, 5, 5}, 1.0, 0.3);
  world.block({0, 0, 0}, {0, 4, 4});
  ASSERT_FALSE(world.grid.free({1, 2, 2}));
  PathRunner runner;
  ASSERT_EQ(runner.run(world.grid, Vec3{1.35, 2.5, 2.5}, Vec3{6.5, 2.5, 2.5}), Status::kOk);
  const Path& path = runner.path();
  ASSERT_EQ(path.count, 3);
  expect_point(path.points[1], {2.5, 2.5, 2.5});
  EXPECT_GE(runner.search().pieces, 2u);
  ASSERT_EQ(runner.run(world.grid, Vec3{6.5, 2.5, 2.5}, Vec3{1.35, 2.5, 2.5}), Status::kOk);
  expect_point(runner.path().points[1], {2.5, 2.5, 2.5});
  // Both ends the same clear point of a voxel that is not free.
  ASSERT_EQ(runner.run(world.grid, Vec3{1.35, 2.5, 2.5}, Vec3{1.35, 2.5, 2.5}), Status::kOk);
  EXPECT_EQ(runner.path().length, 0.0);
}

TEST(PathEnds, JoinGoesAroundWhatBlocksTheNearestCentre) {
  // A plate of half-free voxels: whatever the line to a candidate meets is checked with the radius.
  Random random(51);
  PathRunner runner;
  int joined = 0;
  for (int k = 0; k < scaled(400); ++k) {
    VoxelWorld world({8, 8, 8}, 1.0, random.real(0.05, 0.9));
    for (int m = random.integer(1, 30); m > 0; --m) {
      world.grid.mark_voxel({random.integer(0, 7), random.integer(0, 7), random.integer(0, 7)});
    }
    world.grid.inflate();
    const Vec3 start{random.real(0.0, 8.0), random.real(0.0, 8.0), random.real(0.0, 8.0)};
    Voxel goal{};
    if (!random_free(world.grid, random, goal)) continue;
    const double radius = world.grid.spec().radius;
    const bool clear = tern::point_clear(world.grid, start, radius);
    const Status status = runner.run(world.grid, start, world.grid.center(goal));
    if (!clear) {
      ASSERT_EQ(status, Status::kStartOccupied);
      continue;
    }
    if (status != Status::kOk) continue;
    const Path& path = runner.path();
    for (int i = 1; i < path.count; ++i) {
      ASSERT_TRUE(tern::segment_clear(world.grid, path.points[i - 1], path.points[i], radius));
    }
    joined += world.grid.free(world.grid.voxel_of(start)) ? 0 : 1;
  }
  EXPECT_GT(joined, 0);
}

TEST(PathEnds, OccupiedEndsSayWhichAndWhereToGo) {
  VoxelWorld world({8, 5, 5}, 1.0, 0.3);
  world.block({0, 0, 0}, {0, 4, 4});
  PathRunner runner;
  ASSERT_EQ(runner.run(world.grid, Vec3{0.5, 2.5, 2.5}, Vec3{6.5, 2.5, 2.5}), Status::kStartOccupied);
  EXPECT_TRUE(runner.search().raw_occupied);
  ASSERT_TRUE(runner.search().has_nearest_free);
  expect_point(runner.search().nearest_free, {2.5, 2.5, 2.5});
  ASSERT_EQ(runner.run(world.grid, Vec3{6.5, 2.5, 2.5}, Vec3{1.1, 2.5, 2.5}), Status::kGoalOccupied);
  EXPECT_FALSE(runner.search().raw_occupied);
  expect_point(runner.search().nearest_free, {2.5, 2.5, 2.5});
  EXPECT_EQ(runner.last(), tern::Stage::kSearch);
}

TEST(PathEnds, EnclosedGoal) {
  VoxelWorld world({12, 12, 12});
  world.block({4, 4, 4}, {8, 8, 8}).clear({6, 6, 6});
  PathRunner runner;
  EXPECT_EQ(runner.run(world.grid, Voxel{0, 0, 0}, Voxel{6, 6, 6}), Status::kNoPath);
  EXPECT_EQ(runner.run(world.grid, Voxel{6, 6, 6}, Voxel{0, 0, 0}), Status::kNoPath);
  EXPECT_LE(runner.search().pieces, 1u);
}

TEST(PathEnds, FullMapAndOneVoxelMap) {
  VoxelWorld full({3, 3, 3});
  full.block({0, 0, 0}, {2, 2, 2});
  PathRunner runner;
  EXPECT_EQ(runner.run(full.grid, Voxel{0, 0, 0}, Voxel{2, 2, 2}), Status::kStartOccupied);
  EXPECT_FALSE(runner.search().has_nearest_free);
  VoxelWorld one({1, 1, 1});
  ASSERT_EQ(runner.run(one.grid, Vec3{0.0, 0.0, 0.0}, Vec3{1.0, 1.0, 1.0}), Status::kOk);
  EXPECT_EQ(runner.path().count, 2);
  one.block({0, 0, 0});
  EXPECT_EQ(runner.run(one.grid, Vec3{0.4, 0.5, 0.5}, Vec3{0.6, 0.5, 0.5}), Status::kStartOccupied);
}

TEST(PathEnds, NoDiagonalPastTouchingCorners) {
  VoxelWorld flat({2, 2, 1});
  flat.block({0, 1, 0}).block({1, 0, 0});
  PathRunner runner;
  EXPECT_EQ(runner.run(flat.grid, Voxel{0, 0, 0}, Voxel{1, 1, 0}), Status::kNoPath);
  // One corner free is still a corner cut by the diagonal: around it.
  VoxelWorld half({2, 2, 1});
  half.block({0, 1, 0});
  ASSERT_EQ(runner.run(half.grid, Voxel{0, 0, 0}, Voxel{1, 1, 0}), Status::kOk);
  EXPECT_DOUBLE_EQ(runner.path().grid_length, 2.0);
  // A space diagonal whose box misses one voxel of eight.
  VoxelWorld box({2, 2, 2});
  box.block({1, 0, 0});
  ASSERT_EQ(runner.run(box.grid, Voxel{0, 0, 0}, Voxel{1, 1, 1}), Status::kOk);
  EXPECT_NEAR(runner.path().grid_length, 1.0 + std::sqrt(2.0), 1e-12);
}

}  // namespace
