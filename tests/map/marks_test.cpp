// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a rolling map is told: balls that are free, cylinders, and obstacles known beforehand. Voxels of 0.1 m.
#include <gtest/gtest.h>

#include "support/grid_storage.hpp"
#include "support/owned_map.hpp"

namespace {

using tern::MapSpec;
using tern::Status;
using tern::Vec3;
using tern_test::OwnedMap;

constexpr Vec3 kMiddle{3.2, 1.0, 1.0};
constexpr tern::Cylinder kTrunk{kMiddle, 0.26, 0.12};

MapSpec small_window() {
  return tern::map_spec({0.0, 0.0, 0.0}, 0.1, {64, 20, 20}, 0.0);
}

class MapMarks : public ::testing::Test {
 protected:
  OwnedMap owned{small_window()};
};

/// The route grid has the obstacles of a grid in which the trunk alone was marked, and the safe grid has them too.
void expect_trunk(const OwnedMap& owned) {
  tern_test::OwnedGrid marked(owned.map.route().spec());
  ASSERT_EQ(marked.grid.mark_cylinder(kTrunk), Status::kOk);
  EXPECT_GT(tern_test::count_obstacles(marked.grid), 20);
  const tern::Voxel dims = owned.map.route().spec().dims;
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int x = 0; x < dims.x; ++x) {
        const bool solid = marked.grid.obstacle({x, y, z});
        ASSERT_EQ(owned.map.route().obstacle({x, y, z}), solid) << x << ' ' << y << ' ' << z;
        ASSERT_TRUE(!solid || owned.map.safe().obstacle({x, y, z}));
      }
    }
  }
}

TEST_F(MapMarks, ABallIsTakenForFree) {
  ASSERT_EQ(owned.map.assume_free({1.0, 1.0, 1.0}, 0.26), Status::kOk);
  EXPECT_TRUE(owned.map.seen({10, 10, 10}));
  EXPECT_TRUE(owned.map.seen({11, 10, 10}));   // its farthest corner is 0.245 m away
  EXPECT_FALSE(owned.map.seen({12, 10, 10}));  // 0.332 m
  EXPECT_FALSE(owned.map.seen({11, 11, 10}));  // 0.3 m
  EXPECT_TRUE(owned.map.safe().free({9, 9, 9}));
}

/// Voxels wholly inside it, from 0.52 m up: the layers from 0.6 m to 0.9 m. Farthest corners, in cells,
/// from 10.0, 10.0.
TEST_F(MapMarks, AColumnIsTakenForFreeAboveTheGround) {
  ASSERT_EQ(owned.map.mark_box({{0.95, 0.95, 0.75}, {0.96, 0.96, 0.76}}), Status::kOk);
  const tern::Cylinder column{{1.0, 1.0, 0.52}, 0.26, 0.44};
  ASSERT_EQ(owned.map.assume_column(column), Status::kOk);
  for (int z = 4; z < 11; ++z) {
    const bool is_between = z >= 6 && z < 9;
    EXPECT_EQ(owned.map.seen({10, 10, z}), is_between) << z;
    EXPECT_EQ(owned.map.seen({11, 10, z}), is_between) << z;  // sqrt(4 + 1) = 2.24 cells
    EXPECT_EQ(owned.map.seen({8, 10, z}), is_between) << z;
    EXPECT_FALSE(owned.map.seen({11, 11, z})) << z;  // sqrt(8) = 2.83
    EXPECT_FALSE(owned.map.seen({12, 10, z})) << z;  // sqrt(9 + 1) = 3.16
  }
  EXPECT_TRUE(owned.map.safe().obstacle({9, 9, 7})) << "what was marked stays";
  EXPECT_TRUE(owned.map.seen({9, 9, 7}));
}

/// Within the column, as far as asked for, and as the latest statement says.
TEST_F(MapMarks, TheGroundIsKnownBelowTheColumn) {
  double ground = 7.0;
  EXPECT_FALSE(owned.map.ground_at({1.0, 1.0, 1.0}, 0.0, ground));
  ASSERT_EQ(owned.map.assume_column({{1.0, 1.0, 0.5}, 0.5, 1.0}), Status::kOk);
  EXPECT_FALSE(owned.map.ground_at({1.3, 1.0, 9.0}, 0.21, ground));
  EXPECT_EQ(ground, 7.0);
  EXPECT_TRUE(owned.map.ground_at({1.3, 1.0, 9.0}, 0.19, ground));
  EXPECT_EQ(ground, 0.5);
  EXPECT_FALSE(owned.map.ground_at({1.3, 1.3, 9.0}, 0.19, ground));
  ASSERT_EQ(owned.map.assume_column({{3.0, 1.0, 0.25}, 0.5, 1.0}), Status::kOk);
  EXPECT_FALSE(owned.map.ground_at({1.0, 1.0, 1.0}, 0.19, ground));
  EXPECT_TRUE(owned.map.ground_at({3.0, 1.0, 1.0}, 0.19, ground));
  EXPECT_EQ(ground, 0.25);
}

TEST_F(MapMarks, ACylinderIsSolidInBothGrids) {
  ASSERT_EQ(owned.map.assume_free(kMiddle, 10.0), Status::kOk);
  ASSERT_EQ(owned.map.mark_cylinder(kTrunk), Status::kOk);
  expect_trunk(owned);
}

TEST(MapPrior, ACylinderIsSolidFromTheBeginning) {
  MapSpec spec = small_window();
  spec.prior_cylinders = &kTrunk;
  spec.prior_cylinder_count = 1;
  expect_trunk(OwnedMap(spec));
}

TEST_F(MapMarks, PointsOutsideTheWindowMarkNothing) {
  const Vec3 points[] = {{1.05, 1.05, 1.05}, {-0.05, 1.05, 1.05}, {1.05, 2.05, 1.05}, {1.05, 1.05, 1e9}};
  ASSERT_EQ(owned.map.mark_points(points, 4), Status::kOk);
  EXPECT_EQ(tern_test::count_obstacles(owned.map.route()), 1);
  EXPECT_TRUE(owned.map.route().obstacle({10, 10, 10}));
}

TEST_F(MapMarks, NoPointsMarkNothing) {
  const std::uint64_t before = tern_test::hash_of(owned.map);
  EXPECT_EQ(owned.map.mark_points(nullptr, 0), Status::kOk);
  EXPECT_EQ(tern_test::hash_of(owned.map), before);
}

// What nobody has seen is solid in the safe grid already, but not in the route grid.
TEST_F(MapMarks, TheRevisionGrowsWithEitherGrid) {
  const tern::GridVersion safe = owned.map.safe().version();
  const std::uint64_t revision = owned.map.revision();
  ASSERT_FALSE(owned.map.seen({17, 10, 10}));
  const tern::GridSpec& window = owned.map.safe().spec();
  const Vec3 upper = window.boundary.upper;
  ASSERT_EQ(owned.map.mark_box({{upper.x - window.cell, upper.y - window.cell, upper.z - window.cell}, upper}),
            Status::kOk);
  EXPECT_TRUE(owned.map.safe().version().equals(safe));
  EXPECT_GT(owned.map.revision(), revision);
}

// Both grids take the last of the map's words, the route grid first.
TEST_F(MapMarks, AGridWhoseWordsWereBoundAnewCountsForNothing) {
  const std::uint64_t revision = owned.map.revision();
  ASSERT_GT(owned.map.safe().revision(), 0u);
  const tern::GridSpec spec = owned.map.route().spec();
  const std::size_t count = tern::grid_words(spec.dims);
  tern::Grid other;
  ASSERT_EQ(other.bind(spec, owned.words.data() + (owned.words.size() - 2 * count), count), Status::kOk);
  EXPECT_FALSE(owned.map.route().bound());
  EXPECT_LT(owned.map.revision(), revision);
  EXPECT_EQ(owned.map.revision(), owned.map.safe().revision());
}

}  // namespace
