// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Chains of visible waypoints against every subset.
#include "path/shortcut.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "path/sight.hpp"
#include "support/path_world.hpp"

namespace {

using tern::Path;
using tern::Status;
using tern::Vec3;
using tern::Voxel;
using tern_test::between;
using tern_test::PathRunner;
using tern_test::Random;
using tern_test::random_ends;
using tern_test::random_free;
using tern_test::random_world;
using tern_test::scaled;
using tern_test::VoxelWorld;

/// The cheapest chain over all subsets of the raw points that keep both ends (cell 1).
double cheapest_chain(const tern::Grid& grid, const Path& path) {
  const int inner = path.raw_count - 2;
  double best = 1e18;
  for (int subset = 0; subset < 1 << inner; ++subset) {
    double cost = 0.0;
    int last = 0;
    for (int k = 1; k < path.raw_count && cost < 1e18; ++k) {
      const bool used = k == path.raw_count - 1 || (subset >> (k - 1) & 1) != 0;
      if (!used) continue;
      const bool sees = k == last + 1 || tern::line_of_sight(grid, path.raw[last], path.raw[k]);
      cost = sees ? cost + between(path.raw[last], path.raw[k]) + tern::kLegPrice : 1e18;
      last = k;
    }
    best = std::min(best, cost);
  }
  return best;
}

TEST(PathShortcut, ChainIsTheCheapestOfAllSubsets) {
  Random random(41);
  PathRunner runner;
  int compared = 0;
  for (int k = 0; k < scaled(3000); ++k) {
    const VoxelWorld world = random_world(random);
    Voxel start{};
    Voxel goal{};
    if (!random_ends(world.grid, random, start, goal)) continue;
    if (runner.run(world.grid, start, goal) != Status::kOk) continue;
    if (runner.path().raw_count > 11 || runner.path().raw_count < 3) continue;
    const Path path = tern_test::chain_of(world.grid, runner.path());
    ASSERT_NEAR(path.length + tern::kLegPrice * (path.count - 1), cheapest_chain(world.grid, path), 1e-9);
    ASSERT_LE(path.length, path.raw_length + 1e-9);
    ++compared;
  }
  EXPECT_GT(compared, scaled(3000) / 4);
}

TEST(PathShortcut, InnerSegmentsKeepTheMargin) {
  Random random(42);
  PathRunner runner;
  for (int k = 0; k < scaled(1000); ++k) {
    const VoxelWorld world = random_world(random);
    Voxel a{};
    Voxel b{};
    if (!random_free(world.grid, random, a) || !random_free(world.grid, random, b)) continue;
    const Vec3 start{a.x + random.unit(), a.y + random.unit(), a.z + random.unit()};
    const Vec3 goal{b.x + random.unit(), b.y + random.unit(), b.z + random.unit()};
    if (runner.run(world.grid, start, goal) != Status::kOk) continue;
    const Path& path = runner.path();
    ASSERT_GE(path.count, 2);
    ASSERT_EQ(between(path.points[0], start) + between(path.points[path.count - 1], goal), 0.0);
    for (int i = 1; i + 2 < path.count; ++i) {
      ASSERT_TRUE(tern::line_of_sight(world.grid, path.points[i], path.points[i + 1]));
    }
    // An end too close to what is not free is joined to its own voxel's centre and to nothing else.
    if (path.count > 2 && !tern::line_of_sight(world.grid, path.points[0], path.points[1])) {
      const Vec3 centre = world.grid.center(a);
      ASSERT_EQ(between(path.points[1], centre), 0.0);
    }
  }
}

TEST(PathShortcut, OpenSpaceIsOneSegment) {
  VoxelWorld world({20, 20, 20});
  PathRunner runner;
  ASSERT_EQ(runner.run(world.grid, Voxel{1, 2, 3}, Voxel{17, 9, 12}), Status::kOk);
  EXPECT_EQ(runner.path().count, 2);
  EXPECT_NEAR(runner.path().length, std::sqrt(16.0 * 16 + 7 * 7 + 9 * 9), 1e-12);
  EXPECT_LE(runner.shortcut().pieces, 3u);
}

TEST(PathShortcut, CollinearPointsFallAway) {
  VoxelWorld world({30, 3, 3});
  PathRunner runner;
  ASSERT_EQ(runner.run(world.grid, Vec3{0.5, 1.5, 1.5}, Vec3{29.25, 1.5, 1.5}), Status::kOk);
  EXPECT_EQ(runner.path().count, 2);
}

}  // namespace
