// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Distances against ternary search on a convex function; clearance against every obstacle cube of the grid.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "grid/distance.hpp"
#include "support/at_once.hpp"
#include "support/grid_storage.hpp"
#include "support/random.hpp"

namespace {

using tern::Box;
using tern::ClosestPair;
using tern::Grid;
using tern::Status;
using tern::Vec3;
using tern::Voxel;
using tern_test::for_each_voxel;
using tern_test::OwnedGrid;
using tern_test::Random;
using tern_test::scaled;
using tern_test::whole_grid;

using Real = long double;

Real excess(Real p, Real lower, Real upper) {
  return p < lower ? lower - p : (p > upper ? p - upper : 0);
}

Real point_distance(const Vec3& a, const Vec3& b, Real t, const Box& box) {
  const Real x = excess(a.x + t * (Real{b.x} - a.x), box.lower.x, box.upper.x);
  const Real y = excess(a.y + t * (Real{b.y} - a.y), box.lower.y, box.upper.y);
  const Real z = excess(a.z + t * (Real{b.z} - a.z), box.lower.z, box.upper.z);
  return std::sqrt(x * x + y * y + z * z);
}

/// The distance is convex along the segment: ternary search finds its minimum to the precision of the type.
Real reference_distance(const Vec3& a, const Vec3& b, const Box& box) {
  Real low = 0;
  Real high = 1;
  for (int k = 0; k < 120; ++k) {
    const Real left = low + (high - low) / 3;
    const Real right = high - (high - low) / 3;
    if (point_distance(a, b, left, box) <= point_distance(a, b, right, box)) {
      high = right;
    } else {
      low = left;
    }
  }
  return std::min({point_distance(a, b, low, box), point_distance(a, b, 0, box), point_distance(a, b, 1, box)});
}

Vec3 random_point(Random& random, double reach) {
  return {random.real(-reach, reach), random.real(-reach, reach), random.real(-reach, reach)};
}

Box random_box(Random& random, double reach) {
  const Vec3 a = random_point(random, reach);
  const Vec3 b = random_point(random, reach);
  Box box{{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
          {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}};
  if (random.chance(0.1)) box.upper.x = box.lower.x;
  if (random.chance(0.1)) box.upper.z = box.lower.z;
  return box;
}

/// Segments of every kind: general, along an axis, in a face's plane, short, of no length.
Vec3 random_other_end(Random& random, const Vec3& a, const Box& box, double reach) {
  Vec3 b = random_point(random, reach);
  switch (random.integer(0, 5)) {
    case 0:
      b.y = a.y;
      b.z = a.z;
      break;
    case 1:
      b.z = a.z;
      break;
    case 2:
      b = {a.x + 1e-7 * b.x, a.y + 1e-7 * b.y, a.z + 1e-7 * b.z};
      break;
    case 3:
      b.x = box.upper.x;
      break;
    case 4:
      if (random.chance(0.3)) b = a;
      break;
    default:
      break;
  }
  return b;
}

TEST(SegmentBoxProperty, EqualsTernarySearch) {
  Random random(201);
  for (int k = 0; k < scaled(60000); ++k) {
    const Box box = random_box(random, 1.0);
    const Vec3 a = random_point(random, 2.5);
    const Vec3 b = random_other_end(random, a, box, 2.5);
    const ClosestPair pair = tern::segment_box_closest(a, b, box);
    ASSERT_NEAR(std::sqrt(pair.distance_squared), static_cast<double>(reference_distance(a, b, box)), 1e-12) << k;
    ASSERT_EQ(pair.distance_squared, tern::segment_box_distance_squared(a, b, box));
    ASSERT_EQ(pair.distance_squared, tern::segment_box_distance_squared(pair.on_segment, pair.on_segment, box));
    ASSERT_GE(pair.t, 0.0);
    ASSERT_LE(pair.t, 1.0);
    ASSERT_EQ(tern::segment_box_distance_squared(pair.on_box, pair.on_box, box), 0.0);
    ASSERT_NEAR(pair.on_segment.x, a.x + pair.t * (b.x - a.x), 1e-14);
    ASSERT_NEAR(pair.on_segment.y, a.y + pair.t * (b.y - a.y), 1e-14);
    ASSERT_NEAR(pair.on_segment.z, a.z + pair.t * (b.z - a.z), 1e-14);
  }
}

TEST(SegmentBoxProperty, DoesNotDependOnTheDirection) {
  Random random(202);
  for (int k = 0; k < scaled(20000); ++k) {
    const Box box = random_box(random, 1.0);
    const Vec3 a = random_point(random, 2.5);
    const Vec3 b = random_other_end(random, a, box, 2.5);
    ASSERT_NEAR(std::sqrt(tern::segment_box_distance_squared(a, b, box)),
                std::sqrt(tern::segment_box_distance_squared(b, a, box)), 1e-13);
  }
}

Box cube_of(const Voxel& v, double cell) {
  return {{v.x * cell, v.y * cell, v.z * cell}, {(v.x + 1) * cell, (v.y + 1) * cell, (v.z + 1) * cell}};
}

/// The least distance of the segment from any obstacle cube; a cube's interior counts as negative.
Real reference_clearance(const Grid& grid, const Vec3& a, const Vec3& b) {
  const double cell = grid.spec().cell;
  Real least = 1e9L;
  for_each_voxel(grid.spec().dims, [&](const Voxel& v) {
    if (!grid.obstacle(v)) return;
    const Box cube = cube_of(v, cell);
    least = std::min(least, reference_distance(a, b, cube));
    const double s = 1e-6;
    const Box core{{cube.lower.x + s, cube.lower.y + s, cube.lower.z + s},
                   {cube.upper.x - s, cube.upper.y - s, cube.upper.z - s}};
    if (reference_distance(a, b, core) < 1e-12L) least = -1;
  });
  return least;
}

Vec3 random_inside(Random& random, const Voxel& dims, double cell) {
  return {cell * random.real(0.0, dims.x), cell * random.real(0.0, dims.y), cell * random.real(0.0, dims.z)};
}

void fill(Random& random, Grid& grid, int most) {
  const Voxel dims = grid.spec().dims;
  const int count = random.integer(0, most);
  for (int k = 0; k < count; ++k) {
    const Voxel v{random.integer(0, dims.x - 1), random.integer(0, dims.y - 1), random.integer(0, dims.z - 1)};
    ASSERT_EQ(grid.mark_voxel(v), Status::kOk);
    // Runs along x, so that they meet the ends of words and of the range read.
    for (int x = v.x; x < dims.x && random.chance(0.6); ++x) ASSERT_EQ(grid.mark_voxel({x, v.y, v.z}), Status::kOk);
  }
}

TEST(ClearProperty, EqualsBruteForce) {
  Random random(203);
  for (int k = 0; k < scaled(250); ++k) {
    const Voxel dims{random.integer(1, 90), random.integer(1, 9), random.integer(1, 9)};
    const double cell = random.chance(0.5) ? 0.1 : random.real(0.05, 1.0);
    OwnedGrid owned(whole_grid(dims, cell, 0.0));
    ASSERT_NO_FATAL_FAILURE(fill(random, owned.grid, 12));
    for (int q = 0; q < 10; ++q) {
      const Vec3 a = random_inside(random, dims, cell);
      const Vec3 b = random.chance(0.3) ? a : random_inside(random, dims, cell);
      const double radius = random.chance(0.3) ? 0.0 : cell * random.real(0.0, 4.0);
      const Real clearance = reference_clearance(owned.grid, a, b);
      if (std::abs(clearance - radius) < 3e-9L && radius > 0.0) continue;
      const bool expected = radius > 0.0 ? clearance >= radius : clearance >= 0;
      ASSERT_EQ(tern::segment_clear(owned.grid, a, b, radius), expected)
          << "case " << k << " clearance " << static_cast<double>(clearance) << " radius " << radius;
      ASSERT_EQ(tern::point_clear(owned.grid, a, radius), tern::segment_clear(owned.grid, a, a, radius));
    }
  }
}

/// Contract C5: any point of a free voxel's closed cube keeps the radius.
TEST(ClearProperty, EveryPointOfAFreeVoxelIsClear) {
  Random random(204);
  for (int k = 0; k < scaled(150); ++k) {
    const Voxel dims{random.integer(1, 100), random.integer(1, 15), random.integer(1, 15)};
    const double cell = random.chance(0.5) ? 0.1 : random.real(0.05, 1.0);
    const double radius = random.chance(0.4) ? cell * random.integer(0, 3) : cell * random.real(0.0, 3.0);
    OwnedGrid owned(whole_grid(dims, cell, radius));
    ASSERT_NO_FATAL_FAILURE(fill(random, owned.grid, 8));
    owned.grid.inflate();
    for (int q = 0; q < 200; ++q) {
      const Voxel v{random.integer(0, dims.x - 1), random.integer(0, dims.y - 1), random.integer(0, dims.z - 1)};
      if (!owned.grid.free(v)) continue;
      const auto place = [&](int index) {
        return cell * (random.chance(0.5) ? index + random.integer(0, 1) : random.real(index, index + 1));
      };
      const Vec3 p{place(v.x), place(v.y), place(v.z)};
      ASSERT_TRUE(tern::point_clear(owned.grid, p, radius)) << p.x << ' ' << p.y << ' ' << p.z << " radius " << radius;
    }
  }
}

TEST(NearestFreeProperty, EqualsBruteForce) {
  Random random(205);
  for (int k = 0; k < scaled(600); ++k) {
    const Voxel dims{random.integer(1, 90), random.integer(1, 9), random.integer(1, 9)};
    OwnedGrid owned(whole_grid(dims, 0.5, 0.0));
    ASSERT_EQ(owned.grid.mark_box({{0, 0, 0}, {0.5 * dims.x, 0.5 * dims.y, 0.5 * dims.z}}), Status::kOk);
    const int openings = random.integer(0, 12);
    for (int o = 0; o < openings; ++o) {
      const Voxel v{random.integer(0, dims.x - 1), random.integer(0, dims.y - 1), random.integer(0, dims.z - 1)};
      ASSERT_EQ(owned.grid.clear_voxel(v), Status::kOk);
    }
    owned.grid.inflate();
    // Quarter voxels make exact ties; some points lie outside.
    const auto place = [&](int count) { return 0.125 * random.integer(-8, 4 * count + 8); };
    const Vec3 p{place(dims.x), place(dims.y), place(dims.z)};
    bool found = false;
    double least = 0.0;
    Voxel expected{0, 0, 0};
    for_each_voxel(dims, [&](const Voxel& v) {  // in the order z, y, x: the first of a tie stays
      if (!owned.grid.free(v)) return;
      const Vec3 c = owned.grid.center(v);
      const double d = (c.x - p.x) * (c.x - p.x) + (c.y - p.y) * (c.y - p.y) + (c.z - p.z) * (c.z - p.z);
      if (found && d >= least) return;
      found = true;
      least = d;
      expected = v;
    });
    Voxel got{-1, -1, -1};
    ASSERT_EQ(tern_test::nearest_free_voxel(owned.grid, p, got), found);
    if (!found) continue;
    ASSERT_EQ(got.x, expected.x);
    ASSERT_EQ(got.y, expected.y);
    ASSERT_EQ(got.z, expected.z);
  }
}

}  // namespace
