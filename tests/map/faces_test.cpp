// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// F03: the boundary's faces are inside wherever the map lies, and what is beyond them by more than rounding is not.
#include <gtest/gtest.h>

#include <cmath>

#include "support/random.hpp"
#include "support/world.hpp"

namespace {

using tern::Status;
using tern::Vec3;
using tern_test::World;

constexpr int kMaps = 8 * 3 * 4 * 3;
constexpr double kUlp = 1.0 / 4503599627370496.0;

/// An empty world whose boundary leaves `margin` cells on each side of the grid.
World empty_world(int dims, double cell, Vec3 origin, double margin) {
  World world({dims, 12, 8}, cell, 0.0, origin);
  const auto shrink = [&](double from, int count, double& lower, double& upper) {
    lower = from + margin * cell;
    upper = from + (count - margin) * cell;
  };
  shrink(origin.x, dims, world.spec.boundary.lower.x, world.spec.boundary.upper.x);
  shrink(origin.y, 12, world.spec.boundary.lower.y, world.spec.boundary.upper.y);
  shrink(origin.z, 8, world.spec.boundary.lower.z, world.spec.boundary.upper.z);
  world.bind_status = world.grid.bind(world.spec, world.words.data(), world.words.size());
  return world;
}

/// Start on one corner of the boundary, goal on the opposite one: the same doubles as in the spec.
void expect_corners_inside(int dims, double cell, Vec3 origin, double margin) {
  World world = empty_world(dims, cell, origin, margin);
  if (world.bind_status != Status::kOk) return;  // coordinates there are too coarse for the cells
  world.request.start.position = world.spec.boundary.upper;
  world.request.goal.position = world.spec.boundary.lower;
  ASSERT_EQ(world.plan(), Status::kOk) << dims << " x " << cell << " at " << origin.x << ", margin " << margin;
  if (margin != std::floor(margin)) return;  // voxels that the boundary cuts are not free
  for (const Vec3& corner : {world.spec.boundary.lower, world.spec.boundary.upper})
    EXPECT_TRUE(world.grid.free(world.grid.voxel_of(world.grid.to_local(corner)))) << origin.x;
}

TEST(MapFaces, AreInsideWhereverTheMapLies) {
  const int every = kMaps / tern_test::scaled(kMaps);  // planners' memory is large: all of it takes minutes elsewhere
  int map = 0;
  for (const double offset : {0.0, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9}) {
    for (const double cell : {0.02, 0.1, 7.3}) {
      for (const int dims : {5, 7, 31, 58}) {
        for (const double margin : {0.0, 1.0, 0.4}) {
          if (map++ % every != 0) continue;
          expect_corners_inside(dims, cell, {offset, -offset, 0.0}, margin);
          expect_corners_inside(dims, cell, {-offset - dims * cell, offset / 3.0, 0.1}, margin);
        }
        if (HasFatalFailure()) return;
      }
    }
  }
  EXPECT_EQ(map, kMaps);
}

/// Metres beyond a face at which no rounding of coordinates there explains the distance: five units in the last place
/// a hundred millionth of a cell, and two nanometres.
double beyond(double face, double cell) {
  return 5.0 * std::abs(face) * kUlp + 1e-8 * cell + 2e-9;
}

TEST(MapFaces, WhatIsBeyondByMoreThanRoundingIsOutside) {
  for (const double offset : {0.0, 1e6, -1e9}) {
    for (const double cell : {0.1, 1.0}) {
      World world = empty_world(20, cell, {offset, offset, offset}, 2.0);
      ASSERT_EQ(world.bind_status, Status::kOk);
      const tern::Box& boundary = world.spec.boundary;
      const Vec3 middle{offset + 10 * cell, offset + 6 * cell, offset + 4 * cell};
      world.request.goal.position = middle;
      for (int a = 0; a < 3; ++a) {
        for (const bool upper : {false, true}) {
          Vec3 point = middle;
          double& moved = a == 0 ? point.x : (a == 1 ? point.y : point.z);
          const Vec3& corner = upper ? boundary.upper : boundary.lower;
          const double face = a == 0 ? corner.x : (a == 1 ? corner.y : corner.z);
          moved = upper ? face + beyond(face, cell) : face - beyond(face, cell);
          world.request.start.position = point;
          EXPECT_EQ(world.plan(), Status::kOutOfMap) << offset << " axis " << a << (upper ? " upper" : " lower");
          EXPECT_FALSE(world.grid.free(world.grid.voxel_of(world.grid.to_local(point))));
        }
      }
    }
  }
}

}  // namespace
