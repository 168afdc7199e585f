// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ends on a corner of the lattice, whose own voxel is cut off from the rest of the map: others meet there, too.
#include <gtest/gtest.h>

#include <memory>

#include "grid/distance.hpp"
#include "path/join.hpp"
#include "support/path_world.hpp"

namespace {

using tern::Join;
using tern::JoinState;
using tern::Status;
using tern::Vec3;
using tern::Voxel;
using tern_test::PathQuery;
using tern_test::PathRunner;
using tern_test::VoxelWorld;

constexpr Vec3 kCorner{4.0, 4.0, 4.0};
constexpr Vec3 kElsewhere{6.5, 1.5, 6.5};
constexpr Vec3 kOutside{0.5, 7.5, 0.5};

/// Blocks the six neighbours: no move leads in or out.
void seal(VoxelWorld& world, const Voxel& v) {
  world.block({v.x - 1, v.y, v.z}).block({v.x + 1, v.y, v.z});
  world.block({v.x, v.y - 1, v.z}).block({v.x, v.y + 1, v.z});
  world.block({v.x, v.y, v.z - 1}).block({v.x, v.y, v.z + 1});
}

void expect_clear(const VoxelWorld& world, const tern::Path& path) {
  for (int i = 1; i < path.count; ++i) {
    EXPECT_TRUE(tern::segment_clear(world.grid, path.points[i - 1], path.points[i], 0.0)) << i;
  }
}

bool inside(const Vec3& p, const Voxel& v) {
  return p.x > v.x && p.x < v.x + 1 && p.y > v.y && p.y < v.y + 1 && p.z > v.z && p.z < v.z + 1;
}

class Pockets : public testing::Test {
 protected:
  Pockets() : world_({8, 8, 8}) { seal(world_, {4, 4, 4}); }
  VoxelWorld world_;
  PathRunner runner_;
};

TEST_F(Pockets, StartJoinsAnotherVoxelThatMeetsThere) {
  ASSERT_TRUE(world_.grid.free(world_.grid.voxel_of(kCorner)));
  ASSERT_EQ(runner_.run(world_.grid, kCorner, kElsewhere), Status::kOk);
  EXPECT_EQ(runner_.path().points[0].x, 4.0);
  EXPECT_FALSE(inside(runner_.path().points[1], {4, 4, 4}));
  expect_clear(world_, runner_.path());
}

TEST_F(Pockets, SoDoesAGoal) {
  ASSERT_EQ(runner_.run(world_.grid, kElsewhere, kCorner), Status::kOk);
  EXPECT_EQ(runner_.path().points[runner_.path().count - 1].z, 4.0);
  expect_clear(world_, runner_.path());
}

TEST_F(Pockets, SoDoBoth) {
  VoxelWorld world({12, 8, 8});
  seal(world, {3, 4, 4});
  seal(world, {8, 4, 4});
  ASSERT_EQ(runner_.run(world.grid, Vec3{3, 4, 4}, Vec3{8, 4, 4}), Status::kOk);
  expect_clear(world, runner_.path());
}

/// A solid block in which three voxels that meet in the corner are free, each on its own.
class ThreePockets : public testing::Test {
 protected:
  ThreePockets() : world_({8, 8, 8}) {
    world_.block({1, 1, 1}, {6, 6, 6}).clear({4, 4, 4}).clear({4, 3, 3}).clear({3, 3, 4});
  }
  VoxelWorld world_;
  PathRunner runner_;
};

TEST_F(ThreePockets, AreTriedOneAfterTheOther) {
  EXPECT_EQ(runner_.run(world_.grid, kCorner, kOutside), Status::kNoPath);
  EXPECT_GE(runner_.search().failed, 3u);
  EXPECT_EQ(runner_.run(world_.grid, kOutside, kCorner), Status::kNoPath);
  world_.clear({2, 3, 4}).clear({1, 3, 4});  // the last one's way out
  ASSERT_EQ(runner_.run(world_.grid, kCorner, kOutside), Status::kOk);
  EXPECT_EQ(runner_.search().failed, 2u);
  EXPECT_TRUE(inside(runner_.path().points[1], {3, 3, 4}) || inside(runner_.path().points[1], {2, 3, 4}));
  expect_clear(world_, runner_.path());
  ASSERT_EQ(runner_.run(world_.grid, kOutside, kCorner), Status::kOk);
  expect_clear(world_, runner_.path());
}

TEST_F(Pockets, AnotherGoalIsSoughtFromEveryStart) {
  // The start's own voxel has a way out and the one tried after it has none; the goal's own voxel has none.
  VoxelWorld world({16, 8, 8});
  world.block({1, 1, 1}, {6, 6, 6}).clear({4, 4, 4}).clear({5, 4, 4}).clear({6, 4, 4}).clear({3, 3, 4});
  seal(world, {12, 4, 4});
  ASSERT_EQ(runner_.run(world.grid, kCorner, Vec3{12, 4, 4}), Status::kOk);
  expect_clear(world, runner_.path());
}

TEST_F(Pockets, NoWayWhereTheGoalIsSealedAltogether) {
  world_.block({0, 0, 0}, {2, 2, 2}).clear({1, 1, 1});
  EXPECT_EQ(runner_.run(world_.grid, kCorner, Vec3{1.5, 1.5, 1.5}), Status::kNoPath);
  EXPECT_EQ(runner_.run(world_.grid, Vec3{1.5, 1.5, 1.5}, kCorner), Status::kNoPath);
  EXPECT_LE(runner_.search().pieces, tern::kSearchBound);
}

TEST_F(Pockets, SlicesOfOneFindTheSamePath) {
  ASSERT_EQ(runner_.run(world_.grid, kCorner, kElsewhere), Status::kOk);
  PathRunner sliced;
  ASSERT_EQ(sliced.run(world_.grid, {kCorner, kElsewhere}, 1), Status::kOk);
  ASSERT_EQ(sliced.path().count, runner_.path().count);
  for (int i = 0; i < sliced.path().count; ++i) {
    EXPECT_EQ(sliced.path().points[i].x, runner_.path().points[i].x);
    EXPECT_EQ(sliced.path().points[i].y, runner_.path().points[i].y);
    EXPECT_EQ(sliced.path().points[i].z, runner_.path().points[i].z);
  }
}

TEST_F(Pockets, JoinOthersLeavesOutWhatWasSearched) {
  const auto join = std::make_unique<Join>();
  tern::Work work;
  join_begin(*join, tern::World(world_.grid), kCorner);
  ASSERT_EQ(join->state, JoinState::kJoined);
  ASSERT_EQ(join->count, 0);
  ASSERT_TRUE(join_others(*join, world_.grid, kCorner, false));
  EXPECT_EQ(join->state, JoinState::kTrying);
  EXPECT_GT(join->count, 1);
  while (join->state == JoinState::kTrying) join_try(*join, tern::World(world_.grid), kCorner, work);
  ASSERT_EQ(join->state, JoinState::kJoined);
  const Voxel first = join->voxel;
  EXPECT_NE(first.x + first.y + first.z, 12) << "not the pocket itself";
  EXPECT_TRUE(world_.grid.free(first));
  // All the others that the corner sees are joined to it by faces: none is left.
  EXPECT_TRUE(join_others(*join, world_.grid, kCorner, false));
  while (join->state == JoinState::kTrying) join_try(*join, tern::World(world_.grid), kCorner, work);
  EXPECT_EQ(join->state, JoinState::kRefused);
  EXPECT_FALSE(join_others(*join, world_.grid, kCorner, false));
}

}  // namespace
