// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/greedy_bresenham.hpp"

#include <gtest/gtest.h>

#include "path/sight.hpp"
#include "support/path_world.hpp"

namespace tern_test {
namespace {

using tern_bench::bresenham_free;
using tern_bench::greedy_bresenham;

TEST(GreedyBresenham, VisitsOneVoxelAStep) {
  VoxelWorld world({8, 8, 8});
  EXPECT_TRUE(bresenham_free(world.grid, {0, 0, 0}, {7, 3, 5}));
  world.block({7, 3, 5});
  EXPECT_FALSE(bresenham_free(world.grid, {0, 0, 0}, {7, 3, 5}));
  // Slope 1/2: y steps after every second voxel; (4, 2) lies on the line and (4, 1) does not.
  VoxelWorld line({9, 5, 1});
  line.block({4, 1, 0});
  EXPECT_TRUE(bresenham_free(line.grid, {0, 0, 0}, {8, 4, 0}));
  line.block({4, 2, 0});
  EXPECT_FALSE(bresenham_free(line.grid, {0, 0, 0}, {8, 4, 0}));
}

TEST(GreedyBresenham, PassesBetweenTouchingCorners) {
  VoxelWorld world({4, 4, 1});
  world.block({1, 2, 0}).block({2, 1, 0});
  EXPECT_TRUE(bresenham_free(world.grid, {1, 1, 0}, {2, 2, 0}));
  EXPECT_FALSE(tern::line_of_sight(world.grid, world.grid.center({1, 1, 0}), world.grid.center({2, 2, 0})));
}

TEST(GreedyBresenham, KeepsTheFarthestPointInSight) {
  VoxelWorld world({9, 5, 1});
  world.block({4, 0, 0}).block({4, 1, 0}).block({4, 2, 0});
  const auto at = [&world](int x, int y) { return world.grid.center({x, y, 0}); };
  const std::vector<tern::Vec3> kept = greedy_bresenham(world.grid, {at(0, 0), at(1, 1), at(3, 3), at(5, 3), at(8, 0)});
  ASSERT_EQ(kept.size(), 4u);
  EXPECT_EQ(kept[1].x, at(3, 3).x);
  EXPECT_EQ(kept[2].x, at(5, 3).x);
  EXPECT_EQ(kept[3].y, at(8, 0).y);
}

}  // namespace
}  // namespace tern_test
