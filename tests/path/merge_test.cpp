// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Paths of few legs: always in sight, never more legs than the chain, and longer than a path can hold before they are
// merged.
#include "path/merge.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "path/sight.hpp"
#include "support/path_world.hpp"

namespace {

using tern::Path;
using tern::Status;
using tern::Vec3;
using tern::Voxel;
using tern_test::between;
using tern_test::chain_of;
using tern_test::PathQuery;
using tern_test::PathRunner;
using tern_test::Random;
using tern_test::random_free;
using tern_test::random_world;
using tern_test::scaled;
using tern_test::VoxelWorld;

PathQuery few_legs(const Vec3& start, const Vec3& goal) {
  PathQuery query{start, goal};
  query.few_legs = true;
  return query;
}

TEST(PathMerge, NeverMoreLegsAndAlwaysInSight) {
  Random random(62);
  PathRunner runner;
  int fewer = 0;
  for (int k = 0; k < scaled(2000); ++k) {
    const VoxelWorld world = random_world(random);
    Voxel a{};
    Voxel b{};
    if (!random_free(world.grid, random, a) || !random_free(world.grid, random, b)) continue;
    if (runner.run(world.grid, few_legs(world.grid.center(a), world.grid.center(b))) != Status::kOk) continue;
    ASSERT_LE(runner.shortcut().pieces, tern::kShortcutBound);
    const Path& path = runner.path();
    const Path chain = chain_of(world.grid, path);
    ASSERT_LE(path.count, chain.count);
    ASSERT_EQ(between(path.points[0], chain.points[0]), 0.0);
    ASSERT_EQ(between(path.points[path.count - 1], chain.points[chain.count - 1]), 0.0);
    double length = 0.0;
    for (int i = 1; i < path.count; ++i) {
      ASSERT_TRUE(tern::line_of_sight(world.grid, path.points[i - 1], path.points[i])) << "case " << k;
      length += between(path.points[i - 1], path.points[i]);
    }
    ASSERT_NEAR(length, path.length, 1e-9);
    fewer += path.count < chain.count ? 1 : 0;
  }
  EXPECT_GT(fewer, scaled(2000) / 40);
}

/// Walls across the way, with a gap at one end, then at the other. A taut path bends at both corners of each gap.
VoxelWorld slalom(int walls) {
  VoxelWorld world({12 * (walls + 1), 30, 1});
  for (int w = 0; w < walls; ++w) {
    const int x = 12 * (w + 1);
    world.block({x, w % 2 == 0 ? 0 : 8, 0}, {x + 2, w % 2 == 0 ? 21 : 29, 0});
  }
  return world;
}

TEST(PathMerge, OneBendAtEachGap) {
  constexpr int kWalls = 6;
  const VoxelWorld world = slalom(kWalls);
  PathRunner runner;
  const Vec3 start = world.grid.center({2, 2, 0});
  const Vec3 goal = world.grid.center({12 * kWalls + 10, 2, 0});
  ASSERT_EQ(runner.run(world.grid, start, goal), Status::kOk);
  const Path tight = runner.path();
  ASSERT_EQ(runner.run(world.grid, few_legs(start, goal)), Status::kOk);
  EXPECT_EQ(runner.path().count, kWalls + 2);
  EXPECT_LT(runner.path().count, tight.count);
  EXPECT_LT(runner.path().length, 1.2 * tight.length);
}

/// A path that only fits after merging, in one go and in slices; and one that does not fit even so.
TEST(PathMerge, FitsWhatTheChainDoesNot) {
  PathRunner runner;
  for (const int walls : {tern::kMaxSegments - 4, tern::kMaxSegments + 8}) {
    const VoxelWorld world = slalom(walls);
    const Vec3 start = world.grid.center({2, 2, 0});
    const Vec3 goal = world.grid.center({12 * walls + 10, 2, 0});
    ASSERT_EQ(runner.run(world.grid, start, goal), Status::kSegmentsFull);
    const Status status = runner.run(world.grid, few_legs(start, goal));
    ASSERT_EQ(status, walls < tern::kMaxSegments ? Status::kOk : Status::kSegmentsFull);
    EXPECT_LE(runner.shortcut().segments_high, tern::kMaxSegments);
    PathRunner sliced;
    ASSERT_EQ(sliced.run(world.grid, few_legs(start, goal), 1), status);
    if (status != Status::kOk) continue;
    ASSERT_EQ(sliced.path().count, runner.path().count);
    for (int i = 0; i < runner.path().count; ++i) {
      ASSERT_EQ(between(sliced.path().points[i], runner.path().points[i]), 0.0);
    }
  }
}

}  // namespace
