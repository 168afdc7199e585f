// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What becomes of the prior where the window moves, and of a snapshot's grid that does not fit the map.
#include <gtest/gtest.h>

#include "base/direction.hpp"
#include "base/math.hpp"
#include "support/grid_storage.hpp"
#include "support/owned_map.hpp"

namespace {

using tern::Box;
using tern::GridSpec;
using tern::MapSpec;
using tern::Status;
using tern_test::finish;
using tern_test::Image;
using tern_test::OwnedGrid;
using tern_test::OwnedMap;

MapSpec wide_spec() {
  MapSpec spec = tern::map_spec({0.0, 0.0, 0.0}, 0.1, {64, 20, 20}, 0.15);
  spec.depth_margin = spec.pose_margin = 0.0;
  spec.range = 6.0;
  return spec;
}

/// A beam along y, one voxel thick: 0.7 m ahead of the camera, from its own row on. Frames of a wall behind the beam
/// clear its first voxels. The window then moves by six voxels along y. What stayed in it stays clear, and in the rows
/// that entered it the beam is solid.
TEST(MapWindow, ThePriorIsMarkedWhereVoxelsEnterAlone) {
  static const Box kBeam{{1.7, 1.0, 1.0}, {1.8, 4.0, 1.1}};
  MapSpec spec = wide_spec();
  spec.prior = &kBeam;
  spec.prior_count = 1;
  OwnedMap owned(spec);
  for (int y = 10; y < 20; ++y) ASSERT_TRUE(owned.map.route().obstacle({17, y, 10})) << y;
  Image image(41, 41, 20.0);
  for (float& z : image.z) z = 2.05f;
  for (int k = 0; k < spec.misses; ++k) {
    ASSERT_EQ(owned.map.begin_frame(image.view, {{1.0, 1.0, 1.0}, {0.5, -0.5, 0.5, -0.5}}, 0), Status::kRunning);
    ASSERT_EQ(finish(owned.map), Status::kOk);
  }
  ASSERT_FALSE(owned.map.route().obstacle({17, 10, 10}));
  ASSERT_TRUE(owned.map.route().obstacle({17, 19, 10}));  // outside the image
  ASSERT_EQ(owned.map.follow({3.2, 1.6, 1.0}), Status::kRunning);
  ASSERT_EQ(finish(owned.map), Status::kOk);
  ASSERT_NEAR(owned.map.route().spec().origin.y, 0.6, 1e-12);
  EXPECT_FALSE(owned.map.route().obstacle({17, 4, 10}));
  for (int y = 13; y < 20; ++y) EXPECT_TRUE(owned.map.route().obstacle({17, y, 10})) << y;
}

/// The grid of a snapshot that lies in other words, or has another cell, size or clearance, is bound first.
class MapSnapshots : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(owned.map.mark_box({{1.0, 1.0, 1.0}, {1.2, 1.2, 1.2}}), Status::kOk); }

  void expect_snapshot_in(OwnedGrid& taken) {
    ASSERT_EQ(taken.status, Status::kOk);
    ASSERT_EQ(taken.grid.mark_box(taken.grid.spec().boundary), Status::kOk);
    ASSERT_EQ(owned.map.snapshot(taken.grid, taken.words.data(), taken.words.size()), Status::kOk);
    const GridSpec& route = owned.map.route().spec();
    EXPECT_EQ(taken.grid.spec().cell, route.cell);
    EXPECT_TRUE(tern::same(taken.grid.spec().dims, route.dims));
    EXPECT_EQ(taken.grid.spec().clearance(), route.clearance());
    EXPECT_TRUE(taken.grid.inflated());
    EXPECT_EQ(tern_test::count_obstacles(taken.grid), 8);
    EXPECT_EQ(tern_test::count_free(taken.grid), tern_test::count_free(owned.map.route()));
  }

  OwnedMap owned{wide_spec()};
  GridSpec spec = owned.map.route().spec();
};

TEST_F(MapSnapshots, InAGridThatFits) {
  OwnedGrid grid(spec);
  expect_snapshot_in(grid);
  expect_snapshot_in(grid);
}

TEST_F(MapSnapshots, InAGridThatFitsAfterASlide) {
  OwnedGrid grid(spec);
  expect_snapshot_in(grid);
  ASSERT_EQ(owned.map.follow({3.2, 1.6, 1.0}), Status::kRunning);
  ASSERT_EQ(finish(owned.map), Status::kOk);
  expect_snapshot_in(grid);
  EXPECT_TRUE(tern::same(grid.grid.spec().origin, owned.map.route().spec().origin));
  EXPECT_NEAR(grid.grid.spec().origin.y, 0.6, 1e-12);
  EXPECT_TRUE(grid.grid.obstacle({10, 4, 10}));
}

TEST_F(MapSnapshots, InAGridOfAnotherCell) {
  OwnedGrid grid(tern_test::whole_grid(spec.dims, 0.2, spec.radius));
  expect_snapshot_in(grid);
}

TEST_F(MapSnapshots, InAGridOfAnotherSize) {
  OwnedGrid grid(tern_test::whole_grid({64, 20, 21}, spec.cell, spec.radius));
  expect_snapshot_in(grid);
}

TEST_F(MapSnapshots, InAGridOfAnotherClearance) {
  OwnedGrid grid(tern_test::whole_grid(spec.dims, spec.cell, 0.25));
  expect_snapshot_in(grid);
}

TEST_F(MapSnapshots, InAGridThatLiesElsewhere) {
  OwnedGrid grid(spec);
  const OwnedGrid elsewhere(spec);
  grid.grid = elsewhere.grid;
  expect_snapshot_in(grid);
}

}  // namespace
