// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The check's clearance test against its definition, voxel by voxel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/proven_clear.hpp"
#include "support/random.hpp"
#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Halfspace;
using tern::Polyhedron;
using tern::Vec3;
using tern::Voxel;

/// How far the best half-space cuts the voxel's cube off, beyond the radius.
double cut_off_by(const World& world, const Polyhedron& polyhedron, const Voxel& v) {
  const double cell = world.spec.cell;
  double best = -1e9;
  for (int p = 0; p < polyhedron.count + polyhedron.redundant; ++p) {
    const Halfspace& plane = polyhedron.planes[p];
    double nearest = 1e9;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 c{(v.x + (corner & 1)) * cell, (v.y + (corner >> 1 & 1)) * cell, (v.z + (corner >> 2 & 1)) * cell};
      nearest = std::min(nearest, plane.normal.x * c.x + plane.normal.y * c.y + plane.normal.z * c.z);
    }
    best = std::max(best, nearest - plane.offset - world.spec.radius);
  }
  return best;
}

/// The least of all obstacles.
double least_cut(const World& world, const Polyhedron& polyhedron) {
  double least = 1e9;
  const Voxel& dims = world.spec.dims;
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int x = 0; x < dims.x; ++x) {
        if (world.grid.obstacle({x, y, z})) least = std::min(least, cut_off_by(world, polyhedron, {x, y, z}));
      }
    }
  }
  return least;
}

/// Faces of a box, and planes in any direction, some of them all but square to x.
Polyhedron random_polyhedron(Random& random, const Vec3& center) {
  Polyhedron result{};
  for (int k = random.integer(4, 14); k > 0; --k) {
    Vec3 n{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
    if (random.chance(0.3)) n = {0.0, n.y, 0.0};
    if (random.chance(0.2)) n = {random.chance(0.5) ? 1.0 : -1.0, 0.0, 0.0};
    if (random.chance(0.2)) n.x = random.real(-1e-8, 1e-8);
    const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    if (length < 1e-3) continue;
    n = {n.x / length, n.y / length, n.z / length};
    const double offset = n.x * center.x + n.y * center.y + n.z * center.z + random.real(0.1, 1.2);
    result.planes[result.count++] = {n, offset};
  }
  if (result.count == 0) result.planes[result.count++] = {{0.0, 0.0, 1.0}, center.z};
  result.redundant = result.count / 3;
  result.count -= result.redundant;
  return result;
}

TEST(PolyhedronClear, IsItsDefinition) {
  Random random(41);
  int clear = 0;
  int touched = 0;
  for (int i = 0; i < scaled(1500); ++i) {
    const Voxel dims{random.chance(0.3) ? random.integer(60, 140) : random.integer(5, 30), random.integer(3, 30),
                     random.integer(3, 20)};
    World world(dims, 0.1, random.chance(0.2) ? 0.0 : random.real(0.05, 0.3));
    const Vec3 center{0.1 * dims.x * random.unit(), 0.1 * dims.y * random.unit(), 0.1 * dims.z * random.unit()};
    Polyhedron polyhedron = random_polyhedron(random, center);
    for (int k = random.integer(1, 60); k > 0; --k) {
      const Voxel v{random.integer(0, dims.x - 1), random.integer(0, dims.y - 1), random.integer(0, dims.z - 1)};
      const bool wanted = random.chance(0.02) || cut_off_by(world, polyhedron, v) > -1e-7;
      if (wanted) world.grid.mark_voxel(v);
    }
    const double least = least_cut(world, polyhedron);
    if (std::fabs(least + tern::kCheckDistance) < 1e-9) continue;  // a tie
    ASSERT_EQ(tern_test::proven_clear(world.grid, polyhedron), least > -tern::kCheckDistance) << i << ' ' << least;
    (least > -tern::kCheckDistance ? clear : touched) += 1;
  }
  EXPECT_GT(clear, scaled(1500) / 4);
  EXPECT_GT(touched, scaled(1500) / 10);
}

TEST(PolyhedronClear, SeesOneVoxelThatAPlaneJustMisses) {
  Random random(42);
  for (int i = 0; i < scaled(500); ++i) {
    World world({70, 20, 12}, 0.1, 0.2);
    const Voxel v{random.integer(20, 69), random.integer(0, 19), random.integer(0, 11)};
    world.grid.mark_voxel(v);
    Vec3 n{random.real(0.01, 1.0), random.real(-1, 1), random.real(-1, 1)};
    const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    Polyhedron polyhedron{};
    polyhedron.count = 1;
    polyhedron.planes[0] = {{n.x / length, n.y / length, n.z / length}, 0.0};
    polyhedron.planes[0].offset = cut_off_by(world, polyhedron, v);
    EXPECT_TRUE(tern_test::proven_clear(world.grid, polyhedron)) << i;
    polyhedron.planes[0].offset += 2e-7;
    EXPECT_FALSE(tern_test::proven_clear(world.grid, polyhedron)) << i;
  }
}

}  // namespace
}  // namespace tern_test
