// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "support/grid_storage.hpp"
#include "tern/grid.hpp"

namespace {

using tern::GridSpec;
using tern::Status;
using tern::Voxel;
using tern_test::count_free;
using tern_test::OwnedGrid;
using tern_test::whole_grid;

/// Blocked voxels of a grid of 21 x 21 x 21 around one obstacle in the middle.
int blocked_around_one(double cell, double radius) {
  OwnedGrid owned(whole_grid({21, 21, 21}, cell, radius));
  EXPECT_EQ(owned.status, Status::kOk);
  EXPECT_EQ(owned.grid.mark_voxel({10, 10, 10}), Status::kOk);
  owned.grid.inflate();
  return 21 * 21 * 21 - count_free(owned.grid);
}

TEST(GridInflate, RadiusZeroBlocksTheObstacleAlone) {
  EXPECT_EQ(blocked_around_one(0.1, 0.0), 1);
  EXPECT_EQ(blocked_around_one(0.1, -0.0), 1);
  EXPECT_EQ(blocked_around_one(0.1, 5e-324), 1);
}

TEST(GridInflate, AnyRadiusBlocksWhatTouches) {
  EXPECT_EQ(blocked_around_one(0.1, 1e-6), 27);
  EXPECT_EQ(blocked_around_one(0.1, 0.099), 27);
}

TEST(GridInflate, ADistanceThatEqualsTheRadiusIsFree) {
  // One cell of gap is as far as the radius: still the 27 that touch.
  EXPECT_EQ(blocked_around_one(0.1, 0.1), 27);
  // The ratio 0.3 / 0.1 is 2.9999999999999996, 0.6 / 0.2 and 0.7 / 0.1 round likewise: the tie must not notice.
  // Gap squares below 9: per axis gaps 0 (3 indices), 1 (2), 2 (2).
  int expected = 0;
  for (int z = -10; z <= 10; ++z) {
    for (int y = -10; y <= 10; ++y) {
      for (int x = -10; x <= 10; ++x) {
        const auto gap = [](int d) { return d == 0 ? 0 : std::abs(d) - 1; };
        expected += gap(x) * gap(x) + gap(y) * gap(y) + gap(z) * gap(z) < 9 ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(blocked_around_one(0.1, 0.3), expected);
  EXPECT_EQ(blocked_around_one(0.1, 0.1 * 3), expected);
  EXPECT_EQ(blocked_around_one(0.2, 0.6), expected);
}

TEST(GridInflate, DiagonalTiesAreFree) {
  // Radius sqrt(2) cells: the gap (1, 1, 0) is a tie and free; (1, 0, 0) is blocked.
  OwnedGrid owned(whole_grid({21, 21, 21}, 0.1, 0.1 * std::sqrt(2.0)));
  ASSERT_EQ(owned.grid.mark_voxel({10, 10, 10}), Status::kOk);
  owned.grid.inflate();
  EXPECT_FALSE(owned.grid.free({12, 10, 10}));
  EXPECT_FALSE(owned.grid.free({12, 11, 9}));
  EXPECT_TRUE(owned.grid.free({12, 12, 10}));
  EXPECT_TRUE(owned.grid.free({13, 10, 10}));
}

TEST(GridInflate, TwoAndAHalfCellsReachThreeAlongAnAxis) {
  OwnedGrid owned(whole_grid({21, 21, 21}, 0.1, 0.25));
  ASSERT_EQ(owned.grid.mark_voxel({10, 10, 10}), Status::kOk);
  owned.grid.inflate();
  EXPECT_FALSE(owned.grid.free({13, 10, 10}));
  EXPECT_TRUE(owned.grid.free({14, 10, 10}));
  EXPECT_FALSE(owned.grid.free({10, 13, 12}));  // gaps 2 and 1: sqrt 5 < 2.5
  EXPECT_TRUE(owned.grid.free({10, 13, 13}));   // gaps 2 and 2: sqrt 8 > 2.5
}

TEST(GridInflate, SpreadsAcrossWords) {
  OwnedGrid owned(whole_grid({200, 1, 1}, 0.1, 0.3));
  ASSERT_EQ(owned.grid.mark_voxel({64, 0, 0}), Status::kOk);
  ASSERT_EQ(owned.grid.mark_voxel({127, 0, 0}), Status::kOk);
  owned.grid.inflate();
  for (int x = 0; x < 200; ++x) {
    const bool near = std::abs(x - 64) <= 3 || std::abs(x - 127) <= 3;
    EXPECT_EQ(owned.grid.free({x, 0, 0}), !near) << x;
  }
}

TEST(GridInflate, DoesNotLeakFromOneRowIntoTheNext) {
  // Rows of exactly one word: the last bit of a row is the neighbour of the first bit of the next in memory.
  OwnedGrid owned(whole_grid({64, 9, 9}, 0.1, 0.15));
  ASSERT_EQ(owned.grid.mark_voxel({63, 4, 4}), Status::kOk);
  owned.grid.inflate();
  for (int z = 0; z < 9; ++z) {
    for (int y = 0; y < 9; ++y) {
      for (int x = 0; x < 60; ++x) EXPECT_TRUE(owned.grid.free({x, y, z}));
    }
  }
}

TEST(GridInflate, PaddingIsBlocked) {
  for (const int width : {1, 63, 64, 65, 100, 128, 130}) {
    OwnedGrid owned(whole_grid({width, 3, 3}, 0.1, 0.2));
    owned.grid.inflate();
    const int last = (width - 1) / 64;
    ASSERT_EQ(owned.grid.row_words(), last + 1);
    const int used = width - 64 * last;
    const std::uint64_t padding = used == 64 ? 0 : ~std::uint64_t{0} << used;
    EXPECT_EQ(owned.grid.blocked_row(1, 1)[last], padding);
    EXPECT_EQ(count_free(owned.grid), width * 9);
  }
}

TEST(GridInflate, AnObstacleAtTheGridsEdgeBlocksInwards) {
  OwnedGrid owned(whole_grid({6, 6, 6}, 0.1, 0.15));
  ASSERT_EQ(owned.grid.mark_voxel({0, 0, 0}), Status::kOk);
  owned.grid.inflate();
  EXPECT_FALSE(owned.grid.free({2, 1, 1}));
  EXPECT_FALSE(owned.grid.free({1, 2, 2}));  // gaps 1 and 1: sqrt 2 < 1.5
  EXPECT_TRUE(owned.grid.free({3, 0, 0}));
  EXPECT_TRUE(owned.grid.free({2, 2, 2}));  // sqrt 3 > 1.5
}

TEST(GridInflate, AFullGridHasNothingFreeAndAOneVoxelGridOne) {
  OwnedGrid full(whole_grid({70, 5, 5}, 0.1, 0.25));
  ASSERT_EQ(full.grid.mark_box({{0, 0, 0}, {7, 0.5, 0.5}}), Status::kOk);
  full.grid.inflate();
  EXPECT_EQ(count_free(full.grid), 0);
  OwnedGrid one(whole_grid({1, 1, 1}, 0.1, 0.25));
  ASSERT_EQ(one.status, Status::kOk);
  one.grid.inflate();
  EXPECT_EQ(count_free(one.grid), 1);
  ASSERT_EQ(one.grid.mark_voxel({0, 0, 0}), Status::kOk);
  one.grid.inflate();
  EXPECT_EQ(count_free(one.grid), 0);
}

TEST(GridInflate, ARadiusLargerThanTheGridBlocksAllOfIt) {
  OwnedGrid owned(whole_grid({150, 20, 10}, 0.1, 100.0));
  ASSERT_EQ(owned.status, Status::kOk);
  ASSERT_EQ(owned.grid.mark_voxel({0, 0, 0}), Status::kOk);
  owned.grid.inflate();
  EXPECT_EQ(count_free(owned.grid), 0);
}

TEST(GridInflate, ClearingFreesAgain) {
  OwnedGrid owned(whole_grid({20, 20, 20}, 0.1, 0.25));
  ASSERT_EQ(owned.grid.mark_box({{0.5, 0.5, 0.5}, {1.0, 1.0, 1.0}}), Status::kOk);
  owned.grid.inflate();
  EXPECT_LT(count_free(owned.grid), 8000);
  ASSERT_EQ(owned.grid.clear_box({{0.5, 0.5, 0.5}, {1.0, 1.0, 1.0}}), Status::kOk);
  owned.grid.inflate();
  EXPECT_EQ(count_free(owned.grid), 8000);
}

TEST(GridInflate, ABoundaryOffTheLatticeBlocksTheVoxelsThatItCuts) {
  GridSpec spec = whole_grid({10, 10, 10}, 0.1, 0.0);
  spec.boundary = {{0.05, 0.1, 0.1 * 3}, {1.0, 0.95, 0.7}};
  OwnedGrid owned(spec);
  ASSERT_EQ(owned.status, Status::kOk);
  owned.grid.inflate();
  EXPECT_FALSE(owned.grid.free({0, 5, 5}));
  EXPECT_TRUE(owned.grid.free({1, 5, 5}));
  EXPECT_TRUE(owned.grid.free({9, 5, 5}));
  EXPECT_FALSE(owned.grid.free({5, 0, 5}));
  EXPECT_TRUE(owned.grid.free({5, 1, 5}));
  EXPECT_TRUE(owned.grid.free({5, 8, 5}));
  EXPECT_FALSE(owned.grid.free({5, 9, 5}));
  EXPECT_FALSE(owned.grid.free({5, 5, 2}));
  EXPECT_TRUE(owned.grid.free({5, 5, 3}));
  EXPECT_TRUE(owned.grid.free({5, 5, 6}));
  EXPECT_FALSE(owned.grid.free({5, 5, 7}));
  EXPECT_EQ(count_free(owned.grid), 9 * 8 * 4);
}

TEST(GridInflate, ABoundaryThinnerThanAVoxelOpensTheLayersThatItMeets) {
  const struct {
    double lower;
    double upper;
    int first;
    int layers;
  } slabs[] = {{0.35, 0.39, 3, 1}, {0.35, 0.41, 3, 2}, {0.35, 0.49, 3, 2}, {0.35, 0.35, 3, 1}, {0.4, 0.4, 3, 2},
               {0.4, 0.45, 4, 1},  {0.35, 0.4, 3, 1},  {0.0, 0.0, 0, 1},   {1.0, 1.0, 9, 1},   {0.35, 0.5, 4, 1}};
  for (const auto& slab : slabs) {
    for (double tern::Vec3::*axis : {&tern::Vec3::x, &tern::Vec3::y, &tern::Vec3::z}) {
      GridSpec spec = whole_grid({10, 10, 10}, 0.1, 0.0);
      spec.boundary.lower.*axis = slab.lower;
      spec.boundary.upper.*axis = slab.upper;
      OwnedGrid owned(spec);
      ASSERT_EQ(owned.status, Status::kOk);
      owned.grid.inflate();
      EXPECT_EQ(count_free(owned.grid), 100 * slab.layers) << slab.lower << " to " << slab.upper;
      for (int k = slab.first; k < slab.first + slab.layers; ++k) {
        EXPECT_TRUE(owned.grid.free(
            {axis == &tern::Vec3::x ? k : 5, axis == &tern::Vec3::y ? k : 5, axis == &tern::Vec3::z ? k : 5}));
      }
    }
  }
}

TEST(GridInflate, ObstaclesBeyondTheBoundaryCountWhereTheGridHoldsThem) {
  GridSpec spec = whole_grid({10, 10, 10}, 0.1, 0.25);
  spec.boundary.lower.x = 0.3;
  OwnedGrid owned(spec);
  ASSERT_EQ(owned.grid.mark_voxel({1, 5, 5}), Status::kOk);
  owned.grid.inflate();
  EXPECT_FALSE(owned.grid.free({4, 5, 5}));
  EXPECT_TRUE(owned.grid.free({5, 5, 5}));
}

TEST(GridInflate, IsTheSameFarFromTheWorldsOrigin) {
  for (const double far : {1e6, -1e9}) {
    OwnedGrid near(whole_grid({40, 30, 20}, 0.1, 0.25));
    GridSpec spec = whole_grid({40, 30, 20}, 0.1, 0.25, {far, far, far});
    OwnedGrid there(spec);
    ASSERT_EQ(there.status, Status::kOk);
    ASSERT_EQ(near.grid.mark_box({{0.3, 0.7, 0.1}, {1.2, 1.1, 1.7}}), Status::kOk);
    ASSERT_EQ(there.grid.mark_box({{far + 0.3, far + 0.7, far + 0.1}, {far + 1.2, far + 1.1, far + 1.7}}), Status::kOk);
    near.grid.inflate();
    there.grid.inflate();
    EXPECT_EQ(tern_test::words_of(near), tern_test::words_of(there));
  }
}

/// A reach of more rows than a word has: changes count by whole blocks of rows, and give what a new grid gives.
TEST(GridInflate, ChangesWithAReachOfManyRows) {
  const GridSpec spec = whole_grid({20, 400, 6}, 0.01, 0.75);
  OwnedGrid owned(spec);
  ASSERT_EQ(owned.status, Status::kOk);
  const Voxel marks[] = {{5, 10, 3}, {15, 390, 3}, {10, 200, 0}};
  for (const Voxel& mark : marks) {
    EXPECT_EQ(owned.grid.mark_voxel(mark), Status::kOk);
    owned.grid.inflate();
    OwnedGrid fresh(spec);
    tern_test::copy_obstacles(owned.grid, fresh.grid);
    fresh.grid.inflate();
    ASSERT_EQ(count_free(owned.grid), count_free(fresh.grid));
  }
  EXPECT_GT(count_free(owned.grid), 0);
  EXPECT_EQ(owned.grid.clear_voxel(marks[1]), Status::kOk);
  owned.grid.inflate();
  EXPECT_TRUE(owned.grid.free({15, 390, 3}));
  EXPECT_FALSE(owned.grid.free({5, 10, 3}));
}

}  // namespace
