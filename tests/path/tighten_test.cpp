// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pulling paths tight: never longer, never more waypoints, always in sight; and at single corners and edges as long as
// geometry says.
#include "path/tighten.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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
using tern_test::PathRunner;
using tern_test::Random;
using tern_test::random_free;
using tern_test::random_world;
using tern_test::scaled;
using tern_test::VoxelWorld;

bool is_waypoint(const Path& path, const Vec3& point) {
  return std::any_of(path.points, path.points + path.count, [&](const Vec3& p) { return between(p, point) <= 0.0; });
}

/// Segments of the tight path that the chain does not have were seen; the ends stay where they are.
void expect_sound(const tern::Grid& grid, const Path& tight, const Path& chain) {
  ASSERT_LE(tight.length, chain.length + 1e-12);
  ASSERT_LE(tight.count, chain.count);
  ASSERT_EQ(between(tight.points[0], chain.points[0]), 0.0);
  ASSERT_EQ(between(tight.points[tight.count - 1], chain.points[chain.count - 1]), 0.0);
  double length = 0.0;
  for (int k = 1; k < tight.count; ++k) {
    length += between(tight.points[k - 1], tight.points[k]);
    const bool moved = !is_waypoint(chain, tight.points[k - 1]) || !is_waypoint(chain, tight.points[k]);
    if (!moved) continue;
    ASSERT_TRUE(tern::line_of_sight(grid, tight.points[k - 1], tight.points[k])) << k;
  }
  ASSERT_NEAR(length, tight.length, 1e-12 * (1.0 + length));
}

TEST(PathTighten, NeverLongerNeverMoreAlwaysInSight) {
  Random random(61);
  PathRunner runner;
  int shorter = 0;
  for (int k = 0; k < scaled(3000); ++k) {
    const VoxelWorld world = random_world(random);
    Voxel a{};
    Voxel b{};
    if (!random_free(world.grid, random, a) || !random_free(world.grid, random, b)) continue;
    const Vec3 start{a.x + random.unit(), a.y + random.unit(), a.z + random.unit()};
    const Vec3 goal{b.x + random.unit(), b.y + random.unit(), b.z + random.unit()};
    if (runner.run(world.grid, start, goal) != Status::kOk) continue;
    ASSERT_LE(runner.shortcut().pieces, tern::kShortcutBound);
    const Path chain = chain_of(world.grid, runner.path());
    ASSERT_NO_FATAL_FAILURE(expect_sound(world.grid, runner.path(), chain)) << "case " << k;
    shorter += runner.path().length < chain.length - 1e-9 ? 1 : 0;
  }
  EXPECT_GT(shorter, scaled(3000) / 10);
}

/// From one side of a wall that ends at a corner to the other, in one layer of voxels.
TEST(PathTighten, BendsAtTheCorner) {
  VoxelWorld world({60, 40, 1});
  world.block({30, 0, 0}, {31, 24, 0});
  PathRunner runner;
  const Vec3 start{5.5, 3.5, 0.5};
  const Vec3 goal{50.5, 6.5, 0.5};
  ASSERT_EQ(runner.run(world.grid, start, goal), Status::kOk);
  const double m = tern::kTightenMargin;
  const Vec3 left{30.0 - m, 25.0 + m, 0.5};
  const Vec3 right{32.0 + m, 25.0 + m, 0.5};
  const double shortest = between(start, left) + between(left, right) + between(right, goal);
  // One waypoint cannot bend at both corners: the path meets above the wall.
  EXPECT_LE(runner.path().length, shortest * 1.02);
  EXPECT_GE(runner.path().length, shortest - 2.0 * m);
  EXPECT_LE(runner.path().count, 4);
}

/// Over a long low wall: the waypoint slides along its upper edge to where the path is shortest.
TEST(PathTighten, SlidesAlongAnEdge) {
  VoxelWorld world({40, 60, 30});
  world.block({20, 0, 0}, {20, 59, 19});
  PathRunner runner;
  const Vec3 start{4.5, 3.5, 10.5};
  const Vec3 goal{36.5, 55.5, 10.5};
  ASSERT_EQ(runner.run(world.grid, start, goal), Status::kOk);
  const double m = tern::kTightenMargin;
  // The wall unfolded: up to its edge, across its top, down again, all in one plane.
  const double up = std::hypot(20.0 - m - start.x, 20.0 + m - start.z);
  const double down = std::hypot(goal.x - 21.0 - m, 20.0 + m - goal.z);
  const double shortest = std::hypot(up + 1.0 + 2.0 * m + down, goal.y - start.y);
  EXPECT_LE(runner.path().length, shortest * 1.02);
  EXPECT_GE(runner.path().length, shortest - 2.0 * m);
}

/// In open space each waypoint falls away, the first one as well, and the ends stay.
TEST(PathTighten, LeavesOutWaypointsFromTheFirstOn) {
  VoxelWorld world({30, 30, 30});
  const std::unique_ptr<Path> path(new Path);
  const Vec3 points[] = {{2.5, 2.5, 2.5}, {9.5, 12.5, 7.5}, {14.5, 10.5, 20.5}, {20.5, 21.5, 9.5}, {27.5, 26.5, 25.5}};
  path->count = 5;
  std::copy(points, points + 5, path->points);
  path->length = 0.0;
  for (int k = 1; k < 5; ++k) path->length += between(points[k - 1], points[k]);
  tern::Tighten tighten;
  tern::tighten_begin(tighten, world.grid, *path);
  int trials = 0;
  for (; tern::tighten_needs_trial(tighten, *path); ++trials) tern::tighten_try(tighten, world.grid, *path);
  EXPECT_EQ(trials, 3);
  ASSERT_EQ(path->count, 2);
  EXPECT_EQ(between(path->points[0], points[0]), 0.0);
  EXPECT_EQ(between(path->points[1], points[4]), 0.0);
  EXPECT_NEAR(path->length, between(points[0], points[4]), 1e-12);
}

}  // namespace
