// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Inflation and marking against brute force: every voxel against every obstacle, cube to cube, in extended precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/grid_storage.hpp"
#include "support/random.hpp"
#include "tern/grid.hpp"

namespace {

using tern::Grid;
using tern::GridSpec;
using tern::Status;
using tern::Vec3;
using tern::Voxel;
using tern_test::for_each_voxel;
using tern_test::OwnedGrid;
using tern_test::Random;
using tern_test::scaled;

using Real = long double;

/// Cells by which the reference forgives: far above rounding at 1e9 m, far below anything random.
constexpr Real kSlack = 1e-5L;

Real separation(int a, int b, Real cell) {
  const Real low = std::max(a * cell, b * cell);
  const Real high = std::min((a + 1) * cell, (b + 1) * cell);
  return std::max(low - high, Real{0});
}

Real cube_distance(const Voxel& a, const Voxel& b, Real cell) {
  const Real x = separation(a.x, b.x, cell);
  const Real y = separation(a.y, b.y, cell);
  const Real z = separation(a.z, b.z, cell);
  return std::sqrt(x * x + y * y + z * z);
}

/// What a case asks for, in local coordinates, before the origin's rounding.
struct Case {
  Voxel dims;
  double cell;
  double radius;
  Vec3 origin;
  tern::Box boundary;
};

/// Cells that lie inside the boundary on one axis; where none does, those that it meets, on both sides of a flat one.
bool counts_as_inside(int index, Real lower, Real upper) {
  if (std::floor(upper + kSlack) > std::ceil(lower - kSlack))
    return index >= lower - kSlack && index + 1 <= upper + kSlack;
  const Real within = upper - lower <= kSlack ? -kSlack : kSlack;
  return index < upper - within && index + 1 > lower + within;
}

bool reference_blocked(const Case& c, const std::vector<Voxel>& obstacles, const Voxel& v) {
  const auto cut = [&](int index, double lower, double upper) {
    return !counts_as_inside(index, static_cast<Real>(lower) / c.cell, static_cast<Real>(upper) / c.cell);
  };
  if (cut(v.x, c.boundary.lower.x, c.boundary.upper.x)) return true;
  if (cut(v.y, c.boundary.lower.y, c.boundary.upper.y)) return true;
  if (cut(v.z, c.boundary.lower.z, c.boundary.upper.z)) return true;
  for (const Voxel& o : obstacles) {
    const Real distance = cube_distance(v, o, c.cell);
    if (distance < c.radius * (1 - 1e-8L)) return true;
    if (o.x == v.x && o.y == v.y && o.z == v.z) return true;
  }
  return false;
}

double random_radius(Random& random, double cell, double most) {
  switch (random.integer(0, 3)) {
    case 0:
      return 0.0;
    case 1:  // ties along an axis
      return cell * random.integer(0, static_cast<int>(most));
    case 2:  // ties on diagonals
      return cell * std::sqrt(static_cast<double>(random.integer(0, static_cast<int>(most * most))));
    default:
      return cell * random.real(0.0, most);
  }
}

double random_cell(Random& random) {
  constexpr double kCells[] = {0.05, 0.1, 0.2, 0.25, 1.0, 1e-3, 7.3};
  return random.chance(0.3) ? random.real(0.01, 3.0) : kCells[random.integer(0, 6)];
}

/// Where a boundary's faces lie on one axis: on the lattice, off it, or at the grid's own faces.
void random_range(Random& random, int count, double cell, double& lower, double& upper) {
  lower = 0.0;
  upper = count * cell;
  if (random.chance(0.4)) return;
  const bool lattice = random.chance(0.3);
  const double a = lattice ? cell * random.integer(0, count) : random.real(0.0, upper);
  double b = lattice ? cell * random.integer(0, count) : random.real(0.0, upper);
  if (random.chance(0.1)) b = std::min(upper, a + (random.chance(0.5) ? 0.0 : cell * random.real(0.01, 1.0)));
  lower = std::min(a, b);
  upper = std::max(a, b);
}

double random_origin(Random& random) {
  constexpr double kOrigins[] = {0.0, -0.0, 1e6, -1e6, 1e9, -1e9};
  return random.chance(0.4) ? random.real(-50.0, 50.0) : kOrigins[random.integer(0, 5)];
}

Case random_case(Random& random, const Voxel& most, double most_radius) {
  Case c;
  c.dims = {random.integer(1, most.x), random.integer(1, most.y), random.integer(1, most.z)};
  c.cell = random_cell(random);
  c.radius = random_radius(random, c.cell, most_radius);
  c.origin = {random_origin(random), random_origin(random), random_origin(random)};
  // A millimetre voxel is finer than coordinates of 1e9 m resolve well.
  if (c.cell < 0.01) c.origin = {0.0, 0.0, 0.0};
  random_range(random, c.dims.x, c.cell, c.boundary.lower.x, c.boundary.upper.x);
  random_range(random, c.dims.y, c.cell, c.boundary.lower.y, c.boundary.upper.y);
  random_range(random, c.dims.z, c.cell, c.boundary.lower.z, c.boundary.upper.z);
  return c;
}

Vec3 to_world(const Case& c, const Vec3& local) {
  return {c.origin.x + local.x, c.origin.y + local.y, c.origin.z + local.z};
}

GridSpec spec_of(const Case& c) {
  return {c.origin, c.cell, c.dims, {to_world(c, c.boundary.lower), to_world(c, c.boundary.upper)}, c.radius, 0.0};
}

void expect_inflation(Random& random, const Case& c, int most_obstacles) {
  OwnedGrid owned(spec_of(c));
  ASSERT_EQ(owned.status, Status::kOk);
  Grid& grid = owned.grid;
  std::vector<Voxel> obstacles;
  const int count = random.integer(0, most_obstacles);
  for (int k = 0; k < count; ++k) {
    const Voxel v{random.integer(0, c.dims.x - 1), random.integer(0, c.dims.y - 1), random.integer(0, c.dims.z - 1)};
    ASSERT_EQ(grid.mark_voxel(v), Status::kOk);
    obstacles.push_back(v);
  }
  grid.inflate();
  int wrong = 0;
  for_each_voxel(c.dims, [&](const Voxel& v) { wrong += grid.free(v) == reference_blocked(c, obstacles, v) ? 1 : 0; });
  ASSERT_EQ(wrong, 0) << c.dims.x << 'x' << c.dims.y << 'x' << c.dims.z << " cell " << c.cell << " radius " << c.radius
                      << " obstacles " << count;
  const int used = (c.dims.x - 1) % 64 + 1;
  const std::uint64_t padding = used == 64 ? 0 : ~std::uint64_t{0} << used;
  for (int z = 0; z < c.dims.z; ++z) {
    for (int y = 0; y < c.dims.y; ++y) {
      ASSERT_EQ(grid.blocked_row(y, z)[grid.row_words() - 1] & padding, padding);
      ASSERT_EQ(grid.obstacle_row(y, z)[grid.row_words() - 1] & padding, 0u);
    }
  }
}

TEST(GridInflateProperty, EqualsBruteForceOnSmallBalls) {
  Random random(106);
  for (int k = 0; k < scaled(1500); ++k) {
    const Case c = random_case(random, {random.chance(0.5) ? 20 : 140, 14, 14}, 6.0);
    ASSERT_NO_FATAL_FAILURE(expect_inflation(random, c, random.chance(0.5) ? 6 : 60));
  }
}

TEST(GridInflateProperty, EqualsBruteForceOnTallFlatAndThinGrids) {
  Random random(102);
  constexpr Voxel kShapes[] = {{1, 1, 300}, {1, 300, 1}, {300, 1, 1}, {70, 90, 1}, {70, 1, 90}, {2, 90, 70}};
  for (int k = 0; k < scaled(600); ++k) {
    const Case c = random_case(random, kShapes[random.integer(0, 5)], 9.0);
    ASSERT_NO_FATAL_FAILURE(expect_inflation(random, c, 20));
  }
}

TEST(GridInflateProperty, EqualsBruteForceOnBallsLargerThanEveryBuffer) {
  Random random(103);
  for (int k = 0; k < scaled(120); ++k) {
    Case c = random_case(random, {200, 60, 30}, 70.0);
    c.radius = c.cell * random.real(14.0, 70.0);
    ASSERT_NO_FATAL_FAILURE(expect_inflation(random, c, 4));
  }
}

TEST(GridInflateProperty, AFreeVoxelStaysFreeWithASmallerRadius) {
  Random random(104);
  for (int k = 0; k < scaled(100); ++k) {
    Case c = random_case(random, {100, 20, 20}, 6.0);
    OwnedGrid large(spec_of(c));
    c.radius *= random.unit();
    OwnedGrid small(spec_of(c));
    for (int o = 0; o < 20; ++o) {
      const Voxel v{random.integer(0, c.dims.x - 1), random.integer(0, c.dims.y - 1), random.integer(0, c.dims.z - 1)};
      ASSERT_EQ(large.grid.mark_voxel(v), Status::kOk);
      ASSERT_EQ(small.grid.mark_voxel(v), Status::kOk);
    }
    large.grid.inflate();
    small.grid.inflate();
    for_each_voxel(c.dims, [&](const Voxel& v) { ASSERT_LE(large.grid.free(v), small.grid.free(v)); });
  }
}

/// The reference for a box on one axis: voxels whose interior it meets, else the plate's rule.
bool meets(int index, int count, Real lower, Real upper) {
  const Real plane = std::round(lower);
  const bool plate = std::abs(lower - plane) < kSlack && std::abs(upper - plane) < kSlack;
  if (plate) return index == (plane == count ? count - 1 : static_cast<int>(plane));
  return lower < index + 1 - kSlack && upper > index + kSlack;
}

void random_extent(Random& random, int count, double cell, double& lower, double& upper) {
  const auto place = [&] {
    return random.chance(0.5) ? cell * random.integer(-2, count + 2) : cell * random.real(-3.0, count + 3.0);
  };
  const double a = place();
  const double b = random.chance(0.15) ? a : place();
  lower = std::min(a, b);
  upper = std::max(a, b);
}

TEST(GridMarkProperty, BoxesEqualBruteForce) {
  Random random(105);
  for (int k = 0; k < scaled(400); ++k) {
    const Case c = random_case(random, {150, 12, 12}, 0.0);
    OwnedGrid owned(spec_of(c));
    ASSERT_EQ(owned.status, Status::kOk);
    std::vector<bool> expected(static_cast<std::size_t>(c.dims.x) * c.dims.y * c.dims.z, false);
    for (int step = 0; step < 8; ++step) {
      tern::Box box;
      random_extent(random, c.dims.x, c.cell, box.lower.x, box.upper.x);
      random_extent(random, c.dims.y, c.cell, box.lower.y, box.upper.y);
      random_extent(random, c.dims.z, c.cell, box.lower.z, box.upper.z);
      const tern::Box world{to_world(c, box.lower), to_world(c, box.upper)};
      const bool mark = random.chance(0.7);
      ASSERT_EQ(mark ? owned.grid.mark_box(world) : owned.grid.clear_box(world), Status::kOk);
      std::size_t wrong = 0;
      std::size_t i = 0;
      for_each_voxel(c.dims, [&](const Voxel& v) {
        if (meets(v.x, c.dims.x, Real{box.lower.x} / c.cell, Real{box.upper.x} / c.cell) &&
            meets(v.y, c.dims.y, Real{box.lower.y} / c.cell, Real{box.upper.y} / c.cell) &&
            meets(v.z, c.dims.z, Real{box.lower.z} / c.cell, Real{box.upper.z} / c.cell)) {
          expected[i] = mark;
        }
        wrong += owned.grid.obstacle(v) != expected[i] ? 1 : 0;
        ++i;
      });
      ASSERT_EQ(wrong, 0u) << "case " << k << " step " << step;
    }
  }
}

TEST(GridMarkProperty, PointsEqualBruteForce) {
  Random random(106);
  for (int k = 0; k < scaled(300); ++k) {
    const Case c = random_case(random, {150, 12, 12}, 0.0);
    OwnedGrid owned(spec_of(c));
    std::vector<Vec3> points;
    std::vector<Voxel> expected;
    for (int p = 0; p < 50; ++p) {
      const Vec3 local{c.cell * random.real(-1.0, c.dims.x + 1.0), c.cell * random.real(-1.0, c.dims.y + 1.0),
                       c.cell * random.real(-1.0, c.dims.z + 1.0)};
      const Voxel v{static_cast<int>(std::floor(local.x / c.cell)), static_cast<int>(std::floor(local.y / c.cell)),
                    static_cast<int>(std::floor(local.z / c.cell))};
      points.push_back(to_world(c, local));
      if (owned.grid.inside(v)) expected.push_back(v);
    }
    std::size_t inside = 0;
    ASSERT_EQ(owned.grid.mark_points(points.data(), points.size(), &inside), Status::kOk);
    ASSERT_EQ(inside, expected.size());
    OwnedGrid reference(spec_of(c));
    for (const Voxel& v : expected) ASSERT_EQ(reference.grid.mark_voxel(v), Status::kOk);
    ASSERT_EQ(tern_test::words_of(owned), tern_test::words_of(reference));
  }
}

}  // namespace
