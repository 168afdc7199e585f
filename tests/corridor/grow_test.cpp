// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One polyhedron at a time: known answers, and each degenerate geometry by name.
#include "corridor/grow.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "support/at_once.hpp"
#include "support/corridor_reference.hpp"
#include "support/random.hpp"

namespace tern_test {
namespace {

using tern::Box;
using tern::GrowScratch;
using tern::Polyhedron;
using tern::Status;
using tern::Vec3;

class CorridorGrow : public ::testing::Test {
 protected:
  Status grow(const MarkedWorld& world, const Vec3& from, const Vec3& to) {
    reset_counters(*scratch_);
    return tern_test::grow_polyhedron(tern::World(world.grid), from, to, *scratch_, polyhedron_);
  }

  /// Grows and holds the result against brute force.
  void expect_good(const MarkedWorld& world, const Vec3& from, const Vec3& to) {
    ASSERT_EQ(grow(world, from, to), Status::kOk);
    const std::vector<Box> cubes = obstacle_cubes(world.grid);
    const double clearance = segment_clearance(from, to, cubes, 1e9);
    expect_clear(polyhedron_, cubes, world.grid.spec().radius, random_);
    expect_holds_segment(world.grid, polyhedron_, clearance);
  }

  /// The largest n.p over the polyhedron.
  double extent(const Vec3& n) const {
    double most = -1e300;
    for (const Vec3& v : vertices_of(polyhedron_)) most = std::max(most, dot3(n, v));
    return most;
  }

  void expect_box(const Vec3& lower, const Vec3& upper) const {
    EXPECT_NEAR(extent({1.0, 0.0, 0.0}), upper.x, 1e-9);
    EXPECT_NEAR(extent({0.0, 1.0, 0.0}), upper.y, 1e-9);
    EXPECT_NEAR(extent({0.0, 0.0, 1.0}), upper.z, 1e-9);
    EXPECT_NEAR(extent({-1.0, 0.0, 0.0}), -lower.x, 1e-9);
    EXPECT_NEAR(extent({0.0, -1.0, 0.0}), -lower.y, 1e-9);
    EXPECT_NEAR(extent({0.0, 0.0, -1.0}), -lower.z, 1e-9);
  }

  std::unique_ptr<GrowScratch> scratch_ = std::make_unique<GrowScratch>();
  Polyhedron polyhedron_{};
  Random random_{99};
};

TEST_F(CorridorGrow, FreeSpaceIsTheLocalBox) {
  const MarkedWorld world({100, 100, 100}, 0.1, 0.25);
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {4.0, 5.0, 5.0}, {6.0, 5.0, 5.0}));
  EXPECT_EQ(polyhedron_.count, 6);
  EXPECT_DOUBLE_EQ(polyhedron_.planes[0].offset, 8.0);
  EXPECT_DOUBLE_EQ(polyhedron_.planes[1].offset, -2.0);
  EXPECT_DOUBLE_EQ(polyhedron_.planes[4].offset, 7.0);
  EXPECT_EQ(scratch_->planes_high, 6);
  EXPECT_EQ(scratch_->boxes_high, 0);
}

TEST_F(CorridorGrow, TheBoundaryCutsTheLocalBoxWhereItIs) {
  const MarkedWorld world({100, 100, 30}, 0.1, 0.25, {{0.03, 0.0, 0.04}, {10.0, 10.0, 2.97}});
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {1.0, 5.0, 1.5}, {3.0, 5.0, 1.5}));
  EXPECT_EQ(polyhedron_.planes[1].offset, -0.03);
  EXPECT_EQ(polyhedron_.planes[4].offset, 2.97);
  EXPECT_EQ(polyhedron_.planes[5].offset, -0.04);
}

TEST_F(CorridorGrow, AWallGivesItsFaceLessTheRadius) {
  MarkedWorld world({100, 100, 30}, 0.1, 0.25);
  world.fill({0, 60, 0}, {100, 65, 30});
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {3.0, 5.0, 1.5}, {6.0, 5.0, 1.5}));
  EXPECT_EQ(polyhedron_.count, 6);  // in place of the local box's own face, which is redundant now
  EXPECT_NEAR(extent({0.0, 1.0, 0.0}), 5.75, 1e-9);
}

TEST_F(CorridorGrow, AnObstacleBeyondTheBoxByLessThanTheRadiusCounts) {
  MarkedWorld world({100, 100, 30}, 0.1, 0.5);
  world.fill({0, 72, 0}, {100, 75, 30});  // from 7.2, the local box ends at 7.0
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {3.0, 5.0, 1.5}, {6.0, 5.0, 1.5}));
  EXPECT_NEAR(extent({0.0, 1.0, 0.0}), 6.7, 1e-9);
}

TEST_F(CorridorGrow, HoverIsAPolyhedronAroundAPoint) {
  MarkedWorld world({40, 40, 40}, 0.1, 0.2);
  world.fill({25, 0, 0}, {30, 40, 40});
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}));
  EXPECT_NEAR(extent({1.0, 0.0, 0.0}), 2.3, 1e-9);
}

TEST_F(CorridorGrow, AlmostAPoint) {
  MarkedWorld world({40, 40, 40}, 0.1, 0.2);
  world.fill({25, 0, 0}, {30, 40, 40});
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {2.0, 2.0, 2.0}, {2.0, 2.0 + 1e-9, 2.0}));
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {2.0, 2.0, 2.0}, {2.0, 2.0 + 1e-5, 2.0}));
}

TEST_F(CorridorGrow, AOneVoxelTunnelIsFilled) {
  MarkedWorld world({40, 20, 20}, 0.1, 0.0);
  world.fill({0, 0, 0}, {40, 20, 20});
  for (int x = 0; x < 40; ++x) world.clear(x, 10, 10);
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {0.5, 1.05, 1.05}, {3.5, 1.05, 1.05}));
  expect_box({0.0, 1.0, 1.0}, {4.0, 1.1, 1.1});
}

TEST_F(CorridorGrow, AnObliqueLineThroughAOneVoxelTunnel) {
  MarkedWorld world({40, 20, 20}, 0.1, 0.0);
  world.fill({0, 0, 0}, {40, 20, 20});
  for (int x = 0; x < 40; ++x) world.clear(x, 10, 10);
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {0.5, 1.005, 1.005}, {3.5, 1.095, 1.095}));
  // 0.005 m of room is all margin: the planes are the walls' faces, not tangents of the needle along the line.
  expect_box({0.0, 1.0, 1.0}, {4.0, 1.1, 1.1});
}

TEST_F(CorridorGrow, AHoverInAPocketOfOneVoxel) {
  MarkedWorld world({20, 20, 20}, 0.1, 0.0);
  world.fill({0, 0, 0}, {20, 20, 20});
  world.clear(10, 10, 10);
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {1.05, 1.05, 1.05}, {1.05, 1.05, 1.05}));
  expect_box({1.0, 1.0, 1.0}, {1.1, 1.1, 1.1});
}

TEST_F(CorridorGrow, AHoverThatTouches) {
  MarkedWorld world({40, 40, 40}, 0.1, 0.2);
  world.fill({25, 0, 0}, {30, 40, 40});
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {2.3, 2.0, 2.0}, {2.3, 2.0, 2.0}));
  expect_box({0.3, 0.0, 0.0}, {2.3, 4.0, 4.0});
}

TEST_F(CorridorGrow, AFlatSlitOneVoxelHigh) {
  MarkedWorld world({40, 40, 20}, 0.1, 0.0);
  world.fill({0, 0, 0}, {40, 40, 10});
  world.fill({0, 0, 11}, {40, 40, 20});
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {0.5, 0.7, 1.05}, {3.1, 2.9, 1.02}));
  expect_box({0.0, 0.0, 1.0}, {4.0, 4.0, 1.1});  // opposite planes must not bend the rest
}

TEST_F(CorridorGrow, ASlitThatTheRadiusFillsToAHair) {
  MarkedWorld world({40, 40, 20}, 0.1, 0.2);
  world.fill({0, 0, 0}, {40, 40, 8});
  world.fill({0, 0, 13}, {40, 40, 20});  // 0.5 m high: 0.1 m is left for the centre
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {0.5, 0.7, 1.05}, {3.1, 2.9, 1.05}));
  EXPECT_NEAR(extent({0.0, 0.0, 1.0}) + extent({0.0, 0.0, -1.0}), 0.1, 1e-9);
}

TEST_F(CorridorGrow, AlongAWallAtTheRadius) {
  MarkedWorld world({60, 40, 40}, 0.1, 0.3);
  world.fill({0, 0, 0}, {60, 10, 40});
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {1.0, 1.3, 2.0}, {5.0, 1.3, 2.0}));
  EXPECT_NEAR(extent({0.0, -1.0, 0.0}), -1.3, 1e-9);
  EXPECT_NEAR(extent({0.0, 1.0, 0.0}), 3.3, 1e-9) << "touching a wall must not cost the space on the other side";
}

TEST_F(CorridorGrow, AlongAWallThatTouches) {
  MarkedWorld world({60, 40, 40}, 0.1, 0.0);
  world.fill({0, 0, 0}, {60, 10, 40});
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {1.0, 1.0, 2.0}, {5.0, 1.0, 2.0}));
  expect_box({0.0, 1.0, 0.0}, {6.0, 3.0, 4.0});
}

TEST_F(CorridorGrow, AlongTheEdgeBetweenTwoWalls) {
  MarkedWorld world({60, 40, 40}, 0.1, 0.0);
  world.fill({0, 0, 0}, {60, 10, 40});
  world.fill({0, 0, 0}, {60, 40, 10});
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {1.0, 1.0, 1.0}, {5.0, 1.0, 1.0}));
  expect_box({0.0, 1.0, 1.0}, {6.0, 3.0, 3.0});
}

TEST_F(CorridorGrow, AlongOneFaceOfASlit) {
  // Opposite planes a voxel apart, and no room before one of them.
  MarkedWorld world({60, 40, 40}, 0.1, 0.0);
  world.fill({0, 0, 0}, {60, 10, 40});
  world.fill({0, 11, 0}, {60, 40, 40});
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {1.0, 1.0, 2.0}, {5.0, 1.0, 2.0}));
  expect_box({0.0, 1.0, 0.0}, {6.0, 1.1, 4.0});
}

TEST_F(CorridorGrow, AStartOnAVoxelFace) {
  MarkedWorld world({60, 40, 40}, 0.1, 0.0);
  world.fill({20, 20, 20}, {22, 22, 22});
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {2.2, 2.1, 2.1}, {4.0, 2.5, 2.2}));
  EXPECT_NEAR(extent({-1.0, 0.0, 0.0}), -2.2, 1e-9);
}

TEST_F(CorridorGrow, AStartOnAVoxelCorner) {
  MarkedWorld world({60, 40, 40}, 0.1, 0.0);
  world.fill({20, 20, 20}, {22, 22, 22});
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {2.2, 2.2, 2.2}, {4.0, 2.5, 2.3}));
  // Three faces leave no room alike; the first is taken.
  EXPECT_NEAR(extent({-1.0, 0.0, 0.0}), -2.2, 1e-9);
  EXPECT_NEAR(extent({0.0, -1.0, 0.0}), -0.2, 1e-9);
  EXPECT_NEAR(extent({0.0, 0.0, -1.0}), -0.2, 1e-9);
}

TEST_F(CorridorGrow, PastAnEdgeThatTouches) {
  MarkedWorld world({60, 40, 40}, 0.1, 0.0);
  world.fill({20, 20, 0}, {22, 22, 40});
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {1.7, 2.7, 2.0}, {2.7, 1.7, 2.0}));
  EXPECT_NEAR(extent({-1.0, -1.0, 0.0}), -4.4, 1e-9) << "the plane of the edge and the segment: x + y >= 4.4";
}

TEST_F(CorridorGrow, BetweenTwoCornersThatTouch) {
  // Two pillars that share an edge's line: the diagonal between them touches both along one line.
  MarkedWorld world({40, 40, 20}, 0.1, 0.0);
  world.fill({10, 20, 0}, {20, 30, 20});
  world.fill({20, 10, 0}, {30, 20, 20});
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {1.5, 1.5, 1.0}, {2.5, 2.5, 1.0}));
  EXPECT_NEAR(extent({1.0, -1.0, 0.0}), 0.0, 1e-9) << "a sheet, x = y";
  EXPECT_NEAR(extent({-1.0, 1.0, 0.0}), 0.0, 1e-9);
}

TEST_F(CorridorGrow, OnTheBoundarysFace) {
  MarkedWorld world({40, 40, 40}, 0.1, 0.2);
  world.fill({30, 0, 0}, {40, 40, 40});
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {0.5, 0.5, 0.0}, {2.0, 2.0, 0.0}));
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}));
}

TEST_F(CorridorGrow, FarFromTheOrigin) {
  MarkedWorld world({2000, 8, 8}, 1000.0, 700.0);
  world.fill({1990, 0, 0}, {2000, 8, 8});
  ASSERT_NO_FATAL_FAILURE(expect_good(world, {1980000.0, 3500.0, 3500.0}, {1985000.0, 4100.0, 3500.0}));
}

TEST_F(CorridorGrow, OutsideTheBoundary) {
  const MarkedWorld world({40, 40, 40}, 0.1, 0.2);
  EXPECT_EQ(grow(world, {-0.1, 1.0, 1.0}, {1.0, 1.0, 1.0}), Status::kOutOfMap);
  EXPECT_EQ(grow(world, {1.0, 1.0, 1.0}, {1.0, 1.0, 4.1}), Status::kOutOfMap);
}

TEST_F(CorridorGrow, BlockedByAnObstacleInside) {
  MarkedWorld world({40, 40, 40}, 0.1, 0.2);
  world.mark(20, 20, 20);
  EXPECT_EQ(grow(world, {1.0, 2.05, 2.05}, {3.0, 2.05, 2.05}), Status::kCorridorBlocked);
  EXPECT_EQ(grow(world, {1.0, 2.29, 2.05}, {3.0, 2.29, 2.05}), Status::kCorridorBlocked);
  EXPECT_EQ(grow(world, {2.05, 2.05, 2.05}, {2.05, 2.05, 2.05}), Status::kCorridorBlocked);
  EXPECT_EQ(grow(world, {1.0, 2.3, 2.05}, {3.0, 2.3, 2.05}), Status::kOk) << "exactly at the radius";
}

TEST_F(CorridorGrow, PiecesAreSmallAndSlicesChangeNoBit) {
  MarkedWorld world({160, 160, 60}, 0.1, 0.1);
  for (int i = 0; i < 12000; ++i) world.mark(random_.integer(0, 159), random_.integer(0, 159), random_.integer(0, 59));
  for (int x = 20; x < 110; ++x) {
    for (int y = 74; y < 87; ++y) {
      for (int z = 24; z < 37; ++z) world.clear(x, y, z);
    }
  }
  const Vec3 from{2.5, 8.05, 3.05};
  const Vec3 to{10.5, 8.05, 3.05};
  ASSERT_EQ(grow(world, from, to), Status::kOk);
  const auto whole = std::make_unique<Polyhedron>(polyhedron_);
  EXPECT_GT(scratch_->boxes_high, 1000);
  reset_counters(*scratch_);
  tern::Growth growth;
  grow_begin(growth, tern::World(world.grid), from, to);
  tern::Operations most = 0;
  tern::Operations sum = 0;
  tern::Progress progress = tern::Progress::kMore;
  while (progress == tern::Progress::kMore) {
    tern::Work unit{1};
    progress = grow_advance(growth, tern::World(world.grid), *scratch_, polyhedron_, unit);
    EXPECT_TRUE(progress == tern::Progress::kDone || !unit.left());
    const tern::Operations spent = tern::kUnit - unit.operations();
    most = std::max(most, spent);
    sum += spent;
  }
  ASSERT_EQ(progress, tern::Progress::kDone);
  EXPECT_EQ(polyhedron_.count, whole->count);
  EXPECT_EQ(std::memcmp(polyhedron_.planes, whole->planes, sizeof(tern::Halfspace) * whole->count), 0);
  EXPECT_LT(most, 250 * tern::kUnit);
  EXPECT_GT(sum, 20 * most);
}

}  // namespace
}  // namespace tern_test
