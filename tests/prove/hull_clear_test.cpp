// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Hulls and obstacle cubes whose distances are known by hand.
#include "prove/hull_clear.hpp"

#include <gtest/gtest.h>

#include "base/math.hpp"
#include "support/grid_storage.hpp"

namespace {

using namespace tern;
using tern_test::OwnedGrid;
using tern_test::whole_grid;

struct Room : OwnedGrid {
  Room() : OwnedGrid(whole_grid({60, 60, 40}, 0.1, 0.4)) {}

  /// Voxels [begin, end) of the row at y = 3.4 and z = 2.0 m.
  void mark_run(int begin, int end) {
    for (int x = begin; x < end; ++x) ASSERT_EQ(grid.mark_voxel({x, 34, 20}), Status::kOk);
  }
  bool clear(const Vec3& from, const Vec3& to, const Clearance& clearance, Voxel& found) const {
    const Vec3 points[2] = {from, to};
    tern::Work work;
    return hull_clear(grid, points, 2, clearance, found, work);
  }
};

/// 0.35 m from the row of mark_run().
constexpr Vec3 kPlace{3.05, 3.05, 2.05};

/// Coordinates that fit no integer, to either side of a grid that is solid all over.
TEST(HullClear, FarPointsMeetNothing) {
  Room room;
  ASSERT_EQ(room.grid.mark_box({{0.0, 0.0, 0.0}, {6.0, 6.0, 4.0}}), Status::kOk);
  const Clearance clearance{0.4, nullptr, 0.0, {}};
  Voxel found{-7, -7, -7};
  for (const double far : {1e12, 6.6, -0.6, -1e12}) {
    for (const Vec3& p : {Vec3{far, 3.0, 2.0}, Vec3{3.0, far, 2.0}, Vec3{3.0, 3.0, far}}) {
      EXPECT_TRUE(room.clear(p, p, clearance, found)) << p.x << " " << p.y << " " << p.z;
    }
  }
  EXPECT_EQ(found.x, -7);
  for (const double near : {6.3, -0.3}) {
    EXPECT_FALSE(room.clear({near, 3.0, 2.0}, {near, 3.0, 2.0}, clearance, found)) << near;
    EXPECT_EQ(found.x, near > 0.0 ? 59 : 0);  // the run's end that is nearest
  }
}

/// Of a run whose ends keep the distance, a voxel that does not is named.
TEST(HullClear, NamesTheVoxelThatIsTooNear) {
  Room room;
  room.mark_run(5, 55);
  const Clearance clearance{0.4, nullptr, 1e-9, {}};
  Voxel found{};
  for (const double x : {1.05, 3.05, 5.05}) {
    EXPECT_FALSE(room.clear({x - 0.01, 3.05, 2.05}, {x + 0.01, 3.05, 2.05}, clearance, found));
    EXPECT_EQ(found.x, static_cast<int>(10.0 * x));
    EXPECT_EQ(found.y, 34);
    EXPECT_EQ(found.z, 20);
  }
}

/// The place may stay as near as it is to the voxels near it; those of the same run that are further away than the
/// distance keep all of it, on either side.
TEST(HullClear, RunIsSplitWhereItComesNearThePlaceThatIsLeft) {
  Room room;
  room.mark_run(5, 55);
  const Clearance leaving{0.4, &kPlace, 1e-9, {}};
  Voxel found{};
  EXPECT_TRUE(room.clear(kPlace, {3.05, 2.55, 2.05}, leaving, found));
  EXPECT_FALSE(room.clear(kPlace, {1.05, 3.05, 2.05}, leaving, found));
  EXPECT_LT(found.x, 28);
  EXPECT_FALSE(room.clear(kPlace, {5.05, 3.05, 2.05}, leaving, found));
  EXPECT_GT(found.x, 30);
}

TEST(HullClear, RunsBesideThePlaceThatIsLeftKeepTheirDistance) {
  const Clearance leaving{0.4, &kPlace, 1e-9, {}};
  for (const int x : {10, 50}) {
    Room room;
    room.mark_run(x, x + 3);
    Voxel found{};
    EXPECT_FALSE(room.clear(kPlace, {0.1 * x, 3.05, 2.05}, leaving, found));
    EXPECT_TRUE(found.x >= x && found.x < x + 3) << found.x;
    EXPECT_TRUE(room.clear(kPlace, {0.1 * x, 2.99, 2.05}, leaving, found));
  }
}

/// A short line may touch an edge or a corner where no distance is asked for, but not go further into the cube than is
/// granted.
TEST(HullClear, ShortLinesMayTouchAnEdge) {
  Room room;
  ASSERT_EQ(room.grid.mark_voxel({30, 30, 20}), Status::kOk);
  const Clearance touching{-2e-9, nullptr, 0.0, {}};
  const Vec3 corner{3.0, 3.0, 2.1};
  const Vec3 on_edge{3.0, 3.04, 2.1};
  const Vec3 inwards{1.0, 0.0, -1.0};
  Voxel found{};
  const auto clear = [&](const Vec3& at, const Vec3& along) {
    return room.clear(at - 1e-5 * along, at + 0.6e-5 * along, touching, found);
  };
  for (const Vec3& along : {Vec3{0.4, 0.0, 0.4}, Vec3{0.4, 0.13, 0.4}, Vec3{-0.3, 0.2, -0.7}, Vec3{0.4, 2.0, 0.4}}) {
    EXPECT_TRUE(clear(on_edge, along));
    EXPECT_TRUE(clear(on_edge + 1e-9 * inwards, along));
    EXPECT_FALSE(clear(on_edge + 1e-8 * inwards, along));
  }
  EXPECT_TRUE(clear(corner, {0.4, -0.8, 0.2}));
  EXPECT_FALSE(clear(on_edge, {0.4, 0.0, -0.4}));
  EXPECT_EQ(found.x, 30);
}

/// Nothing is nearer than a voxel around the place itself: leaving it, any way is as good.
TEST(HullClear, VoxelAroundThePlaceThatIsLeftDoesNotHold) {
  Room room;
  ASSERT_EQ(room.grid.mark_voxel({30, 30, 20}), Status::kOk);
  const Clearance leaving{0.4, &kPlace, 1e-9, {}};
  const Clearance staying{0.4, nullptr, 1e-9, {}};
  Voxel found{};
  EXPECT_TRUE(room.clear(kPlace, {3.55, 3.05, 2.05}, leaving, found));
  EXPECT_TRUE(room.clear({2.9, 3.05, 2.05}, {3.2, 3.05, 2.05}, leaving, found));
  EXPECT_FALSE(room.clear(kPlace, {3.55, 3.05, 2.05}, staying, found));
}

}  // namespace
