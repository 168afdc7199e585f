// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lines of sight against an independent slab test of every blocked voxel.
#include "path/sight.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/path_world.hpp"

namespace {

using tern::Vec3;
using tern::Voxel;
using tern_test::Random;
using tern_test::scaled;
using tern_test::VoxelWorld;

/// True where the segment meets the closed cube of a voxel grown by `margin` (cell 1): the slab method.
bool meets(const Vec3& a, const Vec3& b, const Voxel& v, double margin) {
  const double from[3] = {a.x, a.y, a.z};
  const double to[3] = {b.x, b.y, b.z};
  const int low[3] = {v.x, v.y, v.z};
  double begin = 0.0;
  double end = 1.0;
  for (int i = 0; i < 3; ++i) {
    const double d = to[i] - from[i];
    const double lower = low[i] - margin;
    const double upper = low[i] + 1.0 + margin;
    if (std::abs(d) < 1e-300) {
      if (from[i] < lower || from[i] > upper) return false;
      continue;
    }
    begin = std::max(begin, std::min((lower - from[i]) / d, (upper - from[i]) / d));
    end = std::min(end, std::max((lower - from[i]) / d, (upper - from[i]) / d));
  }
  return begin <= end;
}

/// Blocked voxels, those just outside the grid included, that the thick segment meets.
bool blocked_by_brute_force(const tern::Grid& grid, const Vec3& a, const Vec3& b, double margin) {
  const Voxel& dims = grid.spec().dims;
  for (int z = -1; z <= dims.z; ++z) {
    for (int y = -1; y <= dims.y; ++y) {
      for (int x = -1; x <= dims.x; ++x) {
        if (!grid.free({x, y, z}) && meets(a, b, {x, y, z}, margin)) return true;
      }
    }
  }
  return false;
}

Vec3 random_point(const Voxel& dims, Random& random) {
  // Lattice points, centres, faces and anything else; coincidences are what breaks such code.
  const auto coordinate = [&random](int n) {
    const int kind = random.integer(0, 3);
    if (kind == 0) return random.integer(0, n - 1) + 0.5;
    if (kind == 1) return static_cast<double>(random.integer(0, n));
    if (kind == 2) return random.integer(0, n - 1) + tern::kSightMargin;
    return random.real(0.0, n);
  };
  const double x = coordinate(dims.x);
  const double y = coordinate(dims.y);
  return {x, y, coordinate(dims.z)};
}

TEST(PathSight, AgreesWithBruteForceUpToRounding) {
  Random random(31);
  int seen = 0;
  for (int k = 0; k < scaled(4000); ++k) {
    VoxelWorld world({random.integer(1, 9), random.integer(1, 9), random.integer(1, 9)});
    const Voxel dims = world.grid.spec().dims;
    for (int m = random.integer(0, 12); m > 0; --m) {
      world.grid.mark_voxel(
          {random.integer(0, dims.x - 1), random.integer(0, dims.y - 1), random.integer(0, dims.z - 1)});
    }
    world.grid.inflate();
    for (int q = 0; q < 10; ++q) {
      const Vec3 a = random_point(dims, random);
      const Vec3 b = random_point(dims, random);
      const bool sees = tern::line_of_sight(world.grid, a, b);
      // Safe: what is visible is clear even by a hair more than the margin; tight: what is not visible is not clear by
      // a hair more than the rounding allowance.
      if (sees) {
        ASSERT_FALSE(blocked_by_brute_force(world.grid, a, b, tern::kSightMargin));
      }
      if (!sees) {
        ASSERT_TRUE(blocked_by_brute_force(world.grid, a, b, tern::kSightMargin + 1e-8));
      }
      seen += sees ? 1 : 0;
    }
  }
  EXPECT_GT(seen, scaled(4000));
}

TEST(PathSight, RowsBeyondOneWord) {
  Random random(32);
  for (int k = 0; k < scaled(300); ++k) {
    VoxelWorld world({200, 4, 4});
    for (int m = 0; m < 12; ++m) {
      world.grid.mark_voxel({random.integer(0, 199), random.integer(0, 3), random.integer(0, 3)});
    }
    world.grid.inflate();
    const Vec3 a = random_point({200, 4, 4}, random);
    const Vec3 b = random_point({200, 4, 4}, random);
    const bool blocked = blocked_by_brute_force(world.grid, a, b, tern::kSightMargin);
    if (tern::line_of_sight(world.grid, a, b)) {
      ASSERT_FALSE(blocked);
    }
  }
}

TEST(PathSight, MovesOfTheGridSeeEachOther) {
  VoxelWorld world({5, 5, 5});
  // Everything but the box of a space diagonal and its continuation is blocked.
  for (int z = 0; z < 5; ++z) {
    for (int y = 0; y < 5; ++y) {
      for (int x = 0; x < 5; ++x) {
        const int low = std::min({x, y, z});
        const int high = std::max({x, y, z});
        if (high - low > 1) world.grid.mark_voxel({x, y, z});
      }
    }
  }
  world.grid.inflate();
  EXPECT_TRUE(tern::line_of_sight(world.grid, world.grid.center({0, 0, 0}), world.grid.center({4, 4, 4})));
}

TEST(PathSight, NeverBetweenTouchingCorners) {
  VoxelWorld world({4, 4, 1});
  world.block({1, 2, 0}).block({2, 1, 0});
  EXPECT_FALSE(tern::line_of_sight(world.grid, world.grid.center({1, 1, 0}), world.grid.center({2, 2, 0})));
}

TEST(PathSight, DegenerateSegments) {
  VoxelWorld world({3, 3, 3});
  world.block({2, 1, 1});
  const Vec3 centre = world.grid.center({1, 1, 1});
  EXPECT_TRUE(tern::line_of_sight(world.grid, centre, centre));
  // A point closer to a blocked voxel than the margin sees nothing, itself included.
  EXPECT_FALSE(tern::line_of_sight(world.grid, {1.96, 1.5, 1.5}, {1.96, 1.5, 1.5}));
  EXPECT_TRUE(tern::line_of_sight(world.grid, {1.94, 1.5, 1.5}, {1.94, 1.5, 1.5}));
  EXPECT_TRUE(tern::line_of_sight(world.grid, centre, {1.5 + 1e-300, 1.5 - 1e-15, 1.5}));
}

}  // namespace
