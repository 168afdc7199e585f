// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/grid_storage.hpp"
#include "support/numbers.hpp"
#include "support/random.hpp"
#include "tern/grid.hpp"

namespace {

using tern::Box;
using tern::Status;
using tern::Vec3;
using tern_test::count_obstacles;
using tern_test::kNan;
using tern_test::OwnedGrid;
using tern_test::whole_grid;

/// 100 x 10 x 10 voxels of 0.1 m at the world's origin: rows of one word and a half.
class GridMark : public testing::Test {
 protected:
  OwnedGrid owned{whole_grid({100, 10, 10}, 0.1, 0.0)};
  tern::Grid& grid = owned.grid;

  void expect_only(int x0, int x1, int y0, int y1, int z0, int z1) {
    EXPECT_EQ(count_obstacles(grid), (x1 - x0) * (y1 - y0) * (z1 - z0));
    for (int z = z0; z < z1; ++z) {
      for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) EXPECT_TRUE(grid.obstacle({x, y, z})) << x << ' ' << y << ' ' << z;
      }
    }
  }
};

TEST_F(GridMark, ABoxOnTheLatticeTakesItsVoxelsAndNoMore) {
  // Every one of these corners is off the lattice by rounding: 0.1 * 3, 0.7, 0.6 / 0.1 and so on.
  ASSERT_EQ(grid.mark_box({{0.1 * 3, 0.3, 0.1 + 0.2}, {0.7, 0.1 * 7, 0.6}}), Status::kOk);
  expect_only(3, 7, 3, 7, 3, 6);
}

TEST_F(GridMark, ABoxOffTheLatticeTakesEachVoxelThatItTouchesInside) {
  ASSERT_EQ(grid.mark_box({{0.31, 0.39, 0.3}, {0.61, 0.41, 0.3000001}}), Status::kOk);
  expect_only(3, 7, 3, 5, 3, 4);
}

TEST_F(GridMark, ABoxAcrossWordsTakesTheWholeRun) {
  ASSERT_EQ(grid.mark_box({{6.0, 0.0, 0.0}, {6.8, 0.1, 0.1}}), Status::kOk);
  expect_only(60, 68, 0, 1, 0, 1);
  ASSERT_EQ(grid.clear_box({{6.3, 0.0, 0.0}, {6.5, 0.1, 0.1}}), Status::kOk);
  EXPECT_TRUE(grid.obstacle({62, 0, 0}));
  EXPECT_FALSE(grid.obstacle({63, 0, 0}));
  EXPECT_FALSE(grid.obstacle({64, 0, 0}));
  EXPECT_TRUE(grid.obstacle({65, 0, 0}));
}

TEST_F(GridMark, AWordsEndsAreMarkedAlone) {
  ASSERT_EQ(grid.mark_voxel({63, 0, 0}), Status::kOk);
  ASSERT_EQ(grid.mark_voxel({64, 9, 9}), Status::kOk);
  ASSERT_EQ(grid.mark_voxel({99, 9, 9}), Status::kOk);
  EXPECT_EQ(count_obstacles(grid), 3);
  EXPECT_EQ(grid.obstacle_row(0, 0)[0], std::uint64_t{1} << 63);
  EXPECT_EQ(grid.obstacle_row(0, 0)[1], 0u);
  EXPECT_EQ(grid.obstacle_row(9, 9)[1], (std::uint64_t{1} << 35) | 1u);
}

TEST_F(GridMark, PaddingStaysClearWhenEverythingIsMarked) {
  ASSERT_EQ(grid.mark_box({{-1e9, -1e9, -1e9}, {1e9, 1e9, 1e9}}), Status::kOk);
  EXPECT_EQ(count_obstacles(grid), 100 * 10 * 10);
  for (int z = 0; z < 10; ++z) {
    for (int y = 0; y < 10; ++y) EXPECT_EQ(grid.obstacle_row(y, z)[1] >> 36, 0u);
  }
}

TEST_F(GridMark, APlateOnAPlaneTakesTheSideAbove) {
  ASSERT_EQ(grid.mark_box({{0.0, 0.0, 0.3}, {10.0, 1.0, 0.3}}), Status::kOk);
  expect_only(0, 100, 0, 10, 3, 4);
}

TEST_F(GridMark, APlateOnTheUpperFaceTakesTheSideBelow) {
  ASSERT_EQ(grid.mark_box({{10.0, 0.0, 0.0}, {10.0, 1.0, 1.0}}), Status::kOk);
  expect_only(99, 100, 0, 10, 0, 10);
}

TEST_F(GridMark, APlateOnTheLowerFaceTakesTheSideAbove) {
  ASSERT_EQ(grid.mark_box({{0.0, -0.0, 0.0}, {10.0, 0.0, 1.0}}), Status::kOk);
  expect_only(0, 100, 0, 1, 0, 10);
}

TEST_F(GridMark, APlateOffThePlanesTakesItsVoxel) {
  ASSERT_EQ(grid.mark_box({{0.0, 0.55, 0.0}, {0.1, 0.55, 0.1}}), Status::kOk);
  expect_only(0, 1, 5, 6, 0, 1);
}

TEST_F(GridMark, ARodAndAPointTakeOneVoxelAcross) {
  ASSERT_EQ(grid.mark_box({{1.05, 0.5, 0.5}, {1.25, 0.5, 0.5}}), Status::kOk);
  expect_only(10, 13, 5, 6, 5, 6);
  ASSERT_EQ(grid.clear_box({{1.05, 0.5, 0.5}, {1.25, 0.5, 0.5}}), Status::kOk);
  ASSERT_EQ(grid.mark_box({{10.0, 1.0, 1.0}, {10.0, 1.0, 1.0}}), Status::kOk);
  expect_only(99, 100, 9, 10, 9, 10);
}

TEST_F(GridMark, ASheetThinnerThanTheToleranceIsNotLost) {
  ASSERT_EQ(grid.mark_box({{0.5 - 1e-12, 0.0, 0.0}, {0.5 + 1e-12, 0.1, 0.1}}), Status::kOk);
  expect_only(5, 6, 0, 1, 0, 1);
}

TEST_F(GridMark, PartsOutsideAreIgnored) {
  ASSERT_EQ(grid.mark_box({{-5.0, 0.95, -1.0}, {0.05, 7.0, 0.0}}), Status::kOk);
  EXPECT_EQ(count_obstacles(grid), 0);
  ASSERT_EQ(grid.mark_box({{10.0, 0.0, 0.0}, {11.0, 1.0, 1.0}}), Status::kOk);
  ASSERT_EQ(grid.mark_box({{10.5, 0.0, 0.0}, {10.5, 1.0, 1.0}}), Status::kOk);
  ASSERT_EQ(grid.mark_box({{1e300, 0.0, 0.0}, {1e308, 1.0, 1.0}}), Status::kOk);
  ASSERT_EQ(grid.mark_box({{-1e308, 0.0, 0.0}, {-1e300, 1.0, 1.0}}), Status::kOk);
  ASSERT_EQ(grid.mark_box({{-0.1, 0.0, 0.0}, {-0.1, 1.0, 1.0}}), Status::kOk);
  EXPECT_EQ(count_obstacles(grid), 0);
  ASSERT_EQ(grid.mark_box({{-5.0, 0.95, -1.0}, {0.05, 7.0, 0.05}}), Status::kOk);
  expect_only(0, 1, 9, 10, 0, 1);
}

TEST_F(GridMark, RefusesBoxesThatAreNone) {
  EXPECT_EQ(grid.mark_box({{0, 0, kNan}, {1, 1, 1}}), Status::kNonFiniteInput);
  EXPECT_EQ(grid.clear_box({{0, 0, 0}, {1, std::numeric_limits<double>::infinity(), 1}}), Status::kNonFiniteInput);
  EXPECT_EQ(grid.mark_box({{0, 0.2, 0}, {1, 0.1, 1}}), Status::kInvalidArgument);
  EXPECT_EQ(grid.clear_box({{0.2, 0, 0}, {0.1, 1, 1}}), Status::kInvalidArgument);
  EXPECT_EQ(grid.mark_box({{0, 0, 0.2}, {1, 1, 0.1}}), Status::kInvalidArgument);
  EXPECT_EQ(count_obstacles(grid), 0);
}

TEST_F(GridMark, VoxelsOutsideAreOutOfMap) {
  for (const tern::Voxel v :
       {tern::Voxel{-1, 0, 0}, tern::Voxel{100, 0, 0}, tern::Voxel{0, 10, 0}, tern::Voxel{0, 0, -7}}) {
    EXPECT_EQ(grid.mark_voxel(v), Status::kOutOfMap);
    EXPECT_EQ(grid.clear_voxel(v), Status::kOutOfMap);
  }
}

TEST_F(GridMark, PointsMarkTheVoxelThatHoldsThem) {
  const Vec3 points[] = {{0.0, 0.0, 0.0}, {0.3, 0.7, 0.6}, {9.99, 0.99, 0.99}, {10.0, 0.5, 0.5}, {5.0, -0.01, 0.5}};
  std::size_t inside = 99;
  ASSERT_EQ(grid.mark_points(points, 5, &inside), Status::kOk);
  EXPECT_EQ(inside, 3u);
  EXPECT_EQ(count_obstacles(grid), 3);
  EXPECT_TRUE(grid.obstacle({0, 0, 0}));
  EXPECT_TRUE(grid.obstacle({3, 7, 6}));
  EXPECT_TRUE(grid.obstacle({99, 9, 9}));
}

TEST_F(GridMark, OneBadPointMarksNone) {
  const Vec3 points[] = {{0.5, 0.5, 0.5}, {0.5, kNan, 0.5}};
  std::size_t inside = 99;
  const std::uint64_t revision = grid.revision();
  EXPECT_EQ(grid.mark_points(points, 2, &inside), Status::kNonFiniteInput);
  EXPECT_EQ(inside, 99u);
  EXPECT_EQ(count_obstacles(grid), 0);
  EXPECT_EQ(grid.revision(), revision);
}

TEST_F(GridMark, NoPointsNeedNoStorage) {
  std::size_t inside = 99;
  EXPECT_EQ(grid.mark_points(nullptr, 0, &inside), Status::kOk);
  EXPECT_EQ(inside, 0u);
  EXPECT_EQ(grid.mark_points(nullptr, 1, &inside), Status::kInvalidArgument);
}

TEST_F(GridMark, RevisionCountsSuccessfulChanges) {
  const std::uint64_t start = grid.revision();
  grid.inflate();
  EXPECT_EQ(grid.revision(), start);
  EXPECT_TRUE(grid.inflated());
  EXPECT_EQ(grid.mark_voxel({0, 0, 0}), Status::kOk);
  EXPECT_FALSE(grid.inflated());
  EXPECT_EQ(grid.clear_voxel({0, 0, 0}), Status::kOk);
  EXPECT_EQ(grid.mark_box({{0, 0, 0}, {1, 1, 1}}), Status::kOk);
  EXPECT_EQ(grid.clear_box({{0, 0, 0}, {1, 1, 1}}), Status::kOk);
  const Vec3 point{0.5, 0.5, 0.5};
  EXPECT_EQ(grid.mark_points(&point, 1), Status::kOk);
  EXPECT_EQ(grid.revision(), start + 5);
  EXPECT_EQ(grid.mark_voxel({-1, 0, 0}), Status::kOutOfMap);
  EXPECT_EQ(grid.mark_box({{0, 0, 0}, {-1, 1, 1}}), Status::kInvalidArgument);
  EXPECT_EQ(grid.revision(), start + 5);
  EXPECT_FALSE(grid.inflated());
  grid.inflate();
  EXPECT_TRUE(grid.inflated());
}

TEST(GridMarkFar, ABoxOnTheLatticeTakesTheSameVoxelsWhereverTheMapLies) {
  for (const double far : {0.0, 1e6, -1e6, 1e9, -1e9}) {
    OwnedGrid owned(whole_grid({30, 30, 30}, 0.1, 0.0, {far, far, far}));
    ASSERT_EQ(owned.status, Status::kOk) << far;
    // At 1e9 m these corners round by up to 1e-6 of a voxel.
    ASSERT_EQ(owned.grid.mark_box({{far + 0.3, far + 0.7, far + 1.1}, {far + 0.6, far + 1.3, far + 2.9}}), Status::kOk);
    EXPECT_EQ(count_obstacles(owned.grid), 3 * 6 * 18) << far;
    EXPECT_TRUE(owned.grid.obstacle({3, 7, 11}));
    EXPECT_TRUE(owned.grid.obstacle({5, 12, 28}));
  }
}

// The disc of radius 0.25 around the centre of voxel (20, 5): rows within 0.2 m of it are 5, 5, 5, 5 and 5 voxels wide
// but for the corners, whose nearest points are sqrt(0.15^2 + 0.15^2) = 0.212 away.
TEST_F(GridMark, ACylinderTakesTheVoxelsThatItsDiscMeets) {
  ASSERT_EQ(grid.mark_cylinder({{2.05, 0.55, 0.3}, 0.25, 0.2}), Status::kOk);
  expect_only(18, 23, 3, 8, 3, 5);
  EXPECT_EQ(grid.mark_cylinder({{2.05, 0.55, 0.3}, 0.25, 0.2}), Status::kOk);
  expect_only(18, 23, 3, 8, 3, 5);
}

TEST_F(GridMark, ASmallerDiscLeavesTheCornersOut) {
  ASSERT_EQ(grid.mark_cylinder({{2.05, 0.55, 0.3}, 0.21, 0.1}), Status::kOk);
  EXPECT_EQ(count_obstacles(grid), 21);
  EXPECT_FALSE(grid.obstacle({18, 3, 3}));
  EXPECT_TRUE(grid.obstacle({18, 4, 3}));
  EXPECT_TRUE(grid.obstacle({20, 7, 3}));
}

TEST_F(GridMark, ACylinderWithoutWidthIsItsAxis) {
  ASSERT_EQ(grid.mark_cylinder({{6.45, 0.25, 0.05}, 0.0, 0.4}), Status::kOk);
  expect_only(64, 65, 2, 3, 0, 5);
}

TEST_F(GridMark, CylindersOutsideTheGridMarkNothing) {
  ASSERT_EQ(grid.mark_cylinder({{20.0, 0.5, 0.0}, 1.0, 1.0}), Status::kOk);
  ASSERT_EQ(grid.mark_cylinder({{5.0, 0.5, 1.5}, 1.0, 1.0}), Status::kOk);
  EXPECT_EQ(count_obstacles(grid), 0);
}

TEST_F(GridMark, RefusesWhatIsNoCylinder) {
  EXPECT_EQ(grid.mark_cylinder({{kNan, 0.5, 0.0}, 1.0, 1.0}), Status::kNonFiniteInput);
  EXPECT_EQ(grid.mark_cylinder({{1.0, 0.5, 0.0}, kNan, 1.0}), Status::kNonFiniteInput);
  EXPECT_EQ(grid.mark_cylinder({{1.0, 0.5, 0.0}, 1.0, kNan}), Status::kNonFiniteInput);
  EXPECT_EQ(grid.mark_cylinder({{1.0, 0.5, 0.0}, -1.0, 1.0}), Status::kInvalidArgument);
  EXPECT_EQ(grid.mark_cylinder({{1.0, 0.5, 0.0}, 1.0, -1.0}), Status::kInvalidArgument);
  EXPECT_EQ(tern::Grid().mark_cylinder({{1.0, 0.5, 0.0}, 1.0, 1.0}), Status::kInvalidArgument);
}

// Voxel by voxel: the distance from the axis to the nearest point of the voxel's square.
TEST_F(GridMark, RandomCylindersTakeWhatTheyMeetAndNoMore) {
  tern_test::Random random(5);
  for (int round = 0; round < 200; ++round) {
    OwnedGrid one(whole_grid({100, 10, 10}, 0.1, 0.0));
    const tern::Cylinder c{{random.real(-0.5, 10.5), random.real(-0.5, 1.5), random.real(-0.3, 1.1)},
                           random.real(0.01, 0.6),
                           random.real(0.01, 0.8)};
    ASSERT_EQ(one.grid.mark_cylinder(c), Status::kOk);
    for (int k = 0; k < 10000; ++k) {
      const tern::Voxel v{k % 100, k / 100 % 10, k / 1000};
      const auto gap = [](double at, int index) { return at - std::min(std::max(at, 0.1 * index), 0.1 * (index + 1)); };
      const double away = std::hypot(gap(c.base.x, v.x), gap(c.base.y, v.y)) - c.radius;
      const double above = std::max(0.1 * v.z - (c.base.z + c.height), c.base.z - 0.1 * (v.z + 1));
      if (std::abs(away) < 1e-8 || std::abs(above) < 1e-8) continue;
      ASSERT_EQ(one.grid.obstacle(v), away < 0.0 && above < 0.0) << round << ": " << v.x << ' ' << v.y << ' ' << v.z;
    }
  }
}

}  // namespace
