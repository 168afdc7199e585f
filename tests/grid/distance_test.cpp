// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid/distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/at_once.hpp"
#include "support/grid_storage.hpp"

namespace {

using tern::Box;
using tern::ClosestPair;
using tern::Status;
using tern::Vec3;
using tern::Voxel;
using tern_test::OwnedGrid;
using tern_test::whole_grid;

constexpr Box kUnit{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};

TEST(PointBox, FaceEdgeCornerInside) {
  EXPECT_EQ(tern::segment_box_distance_squared({0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}, kUnit), 0.0);
  EXPECT_EQ(tern::segment_box_distance_squared({1.0, 0.0, 0.5}, {1.0, 0.0, 0.5}, kUnit), 0.0);
  EXPECT_EQ(tern::segment_box_distance_squared({3.0, 0.5, 0.5}, {3.0, 0.5, 0.5}, kUnit), 4.0);
  EXPECT_EQ(tern::segment_box_distance_squared({-3.0, 5.0, 0.5}, {-3.0, 5.0, 0.5}, kUnit), 25.0);
  EXPECT_EQ(tern::segment_box_distance_squared({3.0, -2.0, 2.0}, {3.0, -2.0, 2.0}, kUnit), 9.0);
}

TEST(SegmentBox, AnEndIsClosest) {
  const ClosestPair pair = tern::segment_box_closest({2.0, 0.5, 0.5}, {5.0, 0.5, 0.5}, kUnit);
  EXPECT_EQ(pair.t, 0.0);
  EXPECT_EQ(pair.distance_squared, 1.0);
  EXPECT_EQ(pair.on_segment.x, 2.0);
  EXPECT_EQ(pair.on_box.x, 1.0);
  const ClosestPair back = tern::segment_box_closest({5.0, 0.5, 0.5}, {2.0, 0.5, 0.5}, kUnit);
  EXPECT_EQ(back.t, 1.0);
  EXPECT_EQ(back.on_segment.x, 2.0);
  EXPECT_EQ(back.distance_squared, 1.0);
}

TEST(SegmentBox, TheMiddleIsClosestToAnEdge) {
  // Past the edge x = y = 1 along the diagonal x + y = 4: nearest at (2, 2), 2 from the edge squared.
  const ClosestPair pair = tern::segment_box_closest({4.0, 0.0, 0.5}, {0.0, 4.0, 0.5}, kUnit);
  EXPECT_EQ(pair.t, 0.5);
  EXPECT_EQ(pair.distance_squared, 2.0);
  EXPECT_EQ(pair.on_box.x, 1.0);
  EXPECT_EQ(pair.on_box.y, 1.0);
  EXPECT_EQ(pair.on_box.z, 0.5);
}

TEST(SegmentBox, ThroughTheBoxGivesTheEntry) {
  const ClosestPair pair = tern::segment_box_closest({-1.0, 0.5, 0.5}, {3.0, 0.5, 0.5}, kUnit);
  EXPECT_EQ(pair.distance_squared, 0.0);
  EXPECT_EQ(pair.t, 0.25);
  EXPECT_EQ(pair.on_segment.x, 0.0);
}

TEST(SegmentBox, ParallelToAFaceGivesTheFirstPoint) {
  const ClosestPair pair = tern::segment_box_closest({-1.0, 3.0, 0.5}, {3.0, 3.0, 0.5}, kUnit);
  EXPECT_EQ(pair.distance_squared, 4.0);
  EXPECT_EQ(pair.t, 0.25);
}

TEST(SegmentBox, OfNoLengthIsAPoint) {
  const ClosestPair pair = tern::segment_box_closest({3.0, -2.0, 2.0}, {3.0, -2.0, 2.0}, kUnit);
  EXPECT_EQ(pair.distance_squared, 9.0);
  EXPECT_EQ(pair.t, 0.0);
  EXPECT_EQ(tern::segment_box_distance_squared({0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}, kUnit), 0.0);
}

TEST(SegmentBox, AFlatBoxAndAPointBox) {
  const Box plate{{0.0, 0.0, 2.0}, {1.0, 1.0, 2.0}};
  EXPECT_EQ(tern::segment_box_distance_squared({0.5, 0.5, 0.0}, {0.5, 0.5, 1.5}, plate), 0.25);
  const Box point{{1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}};
  EXPECT_EQ(tern::segment_box_distance_squared({0.0, 1.0, 0.0}, {2.0, 1.0, 0.0}, point), 1.0);
}

/// One obstacle cube [1, 2]^3 in a grid of 5 x 5 x 5 m.
class Clear : public testing::Test {
 protected:
  Clear() { EXPECT_EQ(owned.grid.mark_voxel({1, 1, 1}), Status::kOk); }

  OwnedGrid owned{whole_grid({5, 5, 5}, 1.0, 0.5)};
  const tern::Grid& grid = owned.grid;
};

TEST_F(Clear, ExactlyAtTheRadiusIsClear) {
  EXPECT_TRUE(tern::point_clear(grid, {2.5, 1.5, 1.5}, 0.5));
  EXPECT_FALSE(tern::point_clear(grid, {2.5 - 1e-6, 1.5, 1.5}, 0.5));
  EXPECT_TRUE(tern::point_clear(grid, {2.5 - 5e-10, 1.5, 1.5}, 0.5));
  EXPECT_TRUE(tern::segment_clear(grid, {2.5, 0.0, 1.5}, {2.5, 4.0, 1.5}, 0.5));
  EXPECT_FALSE(tern::segment_clear(grid, {2.5, 0.0, 1.5}, {2.49, 4.0, 1.5}, 0.5));
}

TEST_F(Clear, CornersAreRound) {
  const double d = 0.5 / std::sqrt(3.0);
  EXPECT_TRUE(tern::point_clear(grid, {2.0 + d, 2.0 + d, 2.0 + d}, 0.5));
  EXPECT_FALSE(tern::point_clear(grid, {2.0 + d - 1e-6, 2.0 + d, 2.0 + d}, 0.5));
}

TEST_F(Clear, RadiusZeroMayTouchAndNotEnter) {
  EXPECT_TRUE(tern::point_clear(grid, {2.0, 1.5, 1.5}, 0.0));
  EXPECT_TRUE(tern::point_clear(grid, {2.0, 2.0, 2.0}, 0.0));
  EXPECT_FALSE(tern::point_clear(grid, {1.5, 1.5, 1.5}, 0.0));
  EXPECT_FALSE(tern::point_clear(grid, {2.0 - 1e-6, 1.5, 1.5}, 0.0));
  EXPECT_TRUE(tern::segment_clear(grid, {2.0, 0.0, 1.5}, {2.0, 4.0, 1.5}, 0.0));
  EXPECT_TRUE(tern::segment_clear(grid, {0.0, 4.0, 1.5}, {4.0, 0.0, 1.5}, 0.0));   // the edge x = y = 2
  EXPECT_FALSE(tern::segment_clear(grid, {0.0, 3.9, 1.5}, {3.9, 0.0, 1.5}, 0.0));  // through its corner
  EXPECT_FALSE(tern::segment_clear(grid, {0.5, 1.5, 1.5}, {4.5, 1.5, 1.5}, 0.0));
}

TEST_F(Clear, AnEdgeIsTouchedAsDeepAsAFace) {
  const auto along_edge = [&](double depth) {
    const double sum = 4.0 - std::sqrt(2.0) * depth;
    return tern::segment_clear(grid, {0.0, sum, 1.5}, {sum, 0.0, 1.5}, 0.0);
  };
  EXPECT_TRUE(along_edge(0.9e-9));
  EXPECT_FALSE(along_edge(1.1e-9));
  EXPECT_TRUE(tern::segment_clear(grid, {2.0 - 0.9e-9, 0.0, 1.5}, {2.0 - 0.9e-9, 4.0, 1.5}, 0.0));
  EXPECT_FALSE(tern::segment_clear(grid, {2.0 - 1.1e-9, 0.0, 1.5}, {2.0 - 1.1e-9, 4.0, 1.5}, 0.0));
}

TEST_F(Clear, NeighboursLeaveNoGapForRadiusZero) {
  for (const Voxel beside : {Voxel{2, 1, 1}, Voxel{1, 2, 1}, Voxel{1, 1, 2}}) {
    OwnedGrid pair(whole_grid({5, 5, 5}, 1.0, 0.5));
    ASSERT_EQ(pair.grid.mark_voxel({1, 1, 1}), Status::kOk);
    ASSERT_EQ(pair.grid.mark_voxel(beside), Status::kOk);
    const Vec3 between{1.5 + 0.5 * (beside.x - 1), 1.5 + 0.5 * (beside.y - 1), 1.5 + 0.5 * (beside.z - 1)};
    EXPECT_FALSE(tern::point_clear(pair.grid, between, 0.0));
    EXPECT_TRUE(tern::point_clear(pair.grid, {between.x, between.y, 1.0}, 0.0));
  }
  OwnedGrid four(whole_grid({5, 5, 5}, 1.0, 0.5));
  ASSERT_EQ(four.grid.mark_box({{1, 1, 1}, {2, 3, 3}}), Status::kOk);
  EXPECT_FALSE(tern::point_clear(four.grid, {1.5, 2.0, 2.0}, 0.0));
  ASSERT_EQ(four.grid.clear_voxel({1, 2, 2}), Status::kOk);
  EXPECT_TRUE(tern::point_clear(four.grid, {1.5, 2.0, 2.0}, 0.0));
}

TEST_F(Clear, TheBoundaryIsClosed) {
  EXPECT_TRUE(tern::point_clear(grid, {0.0, 0.0, 5.0}, 0.5));
  EXPECT_TRUE(tern::point_clear(grid, {-0.0, 5.0, 5.0}, 0.5));
  EXPECT_FALSE(tern::point_clear(grid, {-1e-6, 4.0, 4.0}, 0.5));
  EXPECT_FALSE(tern::point_clear(grid, {4.0, 4.0, 5.0 + 1e-6}, 0.5));
  EXPECT_FALSE(tern::segment_clear(grid, {4.0, 4.0, 4.0}, {4.0, 4.0, 6.0}, 0.5));
}

TEST_F(Clear, NothingThatIsNoNumberIsClear) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(tern::point_clear(grid, {nan, 4.0, 4.0}, 0.5));
  EXPECT_FALSE(tern::segment_clear(grid, {4.0, 4.0, 4.0}, {4.0, nan, 4.0}, 0.5));
  EXPECT_FALSE(tern::point_clear(grid, {4.0, 4.0, 4.0}, nan));
  EXPECT_FALSE(tern::point_clear(grid, {4.0, 4.0, 4.0}, -1.0));
}

TEST(ClearRows, RunsThatCrossWordsAndBeginBeforeTheRange) {
  OwnedGrid owned(whole_grid({200, 3, 3}, 0.1, 0.1));
  ASSERT_EQ(owned.grid.mark_box({{1.0, 0.0, 0.0}, {15.0, 0.1, 0.1}}), Status::kOk);
  EXPECT_FALSE(tern::point_clear(owned.grid, {6.4, 0.15, 0.05}, 0.06));
  EXPECT_TRUE(tern::point_clear(owned.grid, {6.4, 0.15, 0.05}, 0.05));
  EXPECT_TRUE(tern::point_clear(owned.grid, {15.1, 0.05, 0.05}, 0.1));
  EXPECT_FALSE(tern::point_clear(owned.grid, {15.09, 0.05, 0.05}, 0.1));
  EXPECT_TRUE(tern::point_clear(owned.grid, {0.9, 0.05, 0.05}, 0.1));
}

TEST(NearestFree, PrefersTheNearestThenTheLowestIndex) {
  OwnedGrid owned(whole_grid({9, 9, 9}, 1.0, 0.0));
  ASSERT_EQ(owned.grid.mark_voxel({4, 4, 4}), Status::kOk);
  owned.grid.inflate();
  Voxel out{-5, -5, -5};
  ASSERT_TRUE(tern_test::nearest_free_voxel(owned.grid, {4.5, 4.5, 4.5}, out));
  EXPECT_EQ(out.x, 4);  // six neighbours tie: the lowest z
  EXPECT_EQ(out.y, 4);
  EXPECT_EQ(out.z, 3);
  ASSERT_TRUE(tern_test::nearest_free_voxel(owned.grid, {4.9, 4.5, 4.5}, out));
  EXPECT_EQ(out.x, 5);
  EXPECT_EQ(out.z, 4);
  ASSERT_TRUE(tern_test::nearest_free_voxel(owned.grid, {7.5, 7.5, 7.5}, out));
  EXPECT_EQ(out.x, 7);
}

TEST(NearestFree, OnAPlaneBetweenVoxelsTheLowerIsTaken) {
  OwnedGrid owned(whole_grid({9, 9, 9}, 1.0, 0.0));
  owned.grid.inflate();
  Voxel out{-5, -5, -5};
  for (const Vec3 p : {Vec3{4.0, 4.5, 4.5}, Vec3{4.5, 4.0, 4.5}, Vec3{4.5, 4.5, 4.0}, Vec3{4.0, 4.0, 4.0}}) {
    ASSERT_TRUE(tern_test::nearest_free_voxel(owned.grid, p, out));
    EXPECT_EQ(out.x, p.x > 4.0 ? 4 : 3);
    EXPECT_EQ(out.y, p.y > 4.0 ? 4 : 3);
    EXPECT_EQ(out.z, p.z > 4.0 ? 4 : 3);
  }
}

TEST(NearestFree, SearchesTheWholeGridAndSaysWhereNothingIsFree) {
  OwnedGrid owned(whole_grid({130, 7, 5}, 0.1, 0.0));
  ASSERT_EQ(owned.grid.mark_box({{0, 0, 0}, {13, 0.7, 0.5}}), Status::kOk);
  owned.grid.inflate();
  Voxel out{-5, -5, -5};
  EXPECT_FALSE(tern_test::nearest_free_voxel(owned.grid, {0.0, 0.0, 0.0}, out));
  EXPECT_EQ(out.x, -5);
  ASSERT_EQ(owned.grid.clear_voxel({129, 6, 4}), Status::kOk);
  owned.grid.inflate();
  ASSERT_TRUE(tern_test::nearest_free_voxel(owned.grid, {0.0, 0.0, 0.0}, out));
  EXPECT_EQ(out.x, 129);
  EXPECT_EQ(out.y, 6);
  EXPECT_EQ(out.z, 4);
  ASSERT_TRUE(tern_test::nearest_free_voxel(owned.grid, {-1e300, 1e300, 7.0}, out));
  EXPECT_EQ(out.x, 129);
  for (const Vec3 p : {Vec3{std::nan(""), 0.0, 0.0}, Vec3{0.0, HUGE_VAL, 0.0}, Vec3{0.0, 0.0, std::nan("")}}) {
    EXPECT_FALSE(tern_test::nearest_free_voxel(owned.grid, p, out));
  }
  EXPECT_FALSE(tern_test::nearest_free_voxel(tern::Grid(), {0.0, 0.0, 0.0}, out)) << "no storage to read";
  EXPECT_EQ(out.x, 129);
}

}  // namespace
