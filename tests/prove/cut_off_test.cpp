// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The test of whole rows against its definition, voxel by voxel.
#include "prove/cut_off.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/random.hpp"
#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Halfspace;
using tern::Polyhedron;
using tern::Vec3;
using tern::Voxel;

double dot_of(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// How far the axis or hint that does best keeps the voxel's cube from the hull.
double kept_by(const World& world, const std::vector<Vec3>& hull, const Polyhedron& hints, const Voxel& v) {
  const double cell = world.spec.cell;
  double best = -1e9;
  std::vector<Vec3> normals = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (int p = 0; p < hints.count; ++p) normals.push_back(hints.planes[p].normal);
  for (const Vec3& n : normals) {
    double nearest = 1e9;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 c{(v.x + (corner & 1)) * cell, (v.y + (corner >> 1 & 1)) * cell, (v.z + (corner >> 2 & 1)) * cell};
      nearest = std::min(nearest, dot_of(n, c));
    }
    double support = -1e9;
    for (const Vec3& point : hull) support = std::max(support, dot_of(n, point));
    best = std::max(best, (nearest - support) / std::sqrt(dot_of(n, n)));
  }
  return best;
}

/// The least of all obstacles.
double least_kept(const World& world, const std::vector<Vec3>& hull, const Polyhedron& hints) {
  double least = 1e9;
  const Voxel& dims = world.spec.dims;
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int x = 0; x < dims.x; ++x) {
        if (world.grid.obstacle({x, y, z})) least = std::min(least, kept_by(world, hull, hints, {x, y, z}));
      }
    }
  }
  return least;
}

/// Normals in any direction, some of them axes, and some all but square to x.
Polyhedron random_hints(Random& random) {
  Polyhedron result{};
  for (int k = random.integer(0, 14); k > 0; --k) {
    Vec3 n{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
    if (random.chance(0.3)) n = {0.0, n.y, 0.0};
    if (random.chance(0.2)) n = {random.chance(0.5) ? 1.0 : -1.0, 0.0, 0.0};
    if (random.chance(0.2)) n.x = random.real(-1e-8, 1e-8);
    const double length = std::sqrt(dot_of(n, n));
    if (length < 1e-3) continue;
    result.planes[result.count++] = {{n.x / length, n.y / length, n.z / length}, random.real(-10, 10)};
  }
  return result;
}

std::vector<Vec3> random_hull(Random& random, const Vec3& size) {
  const double spread = random.chance(0.3) ? 0.0 : random.real(0.0, 1.5);
  const Vec3 center{size.x * random.unit(), size.y * random.unit(), size.z * random.unit()};
  std::vector<Vec3> hull;
  for (int i = 0; i < 8; ++i) {
    hull.push_back({center.x + spread * random.real(-1, 1), center.y + spread * random.real(-1, 1),
                    center.z + spread * random.real(-1, 1)});
  }
  return hull;
}

bool is_cut_off(const World& world, const std::vector<Vec3>& hull, const Polyhedron& hints, double distance) {
  tern::Work work;
  return tern::cut_off(world.grid, hull.data(), static_cast<int>(hull.size()), tern::hints_of(hints), distance, work);
}

TEST(CutOff, IsItsDefinition) {
  Random random(41);
  int clear = 0;
  int touched = 0;
  for (int i = 0; i < scaled(1500); ++i) {
    const Voxel dims{random.chance(0.3) ? random.integer(60, 140) : random.integer(5, 30), random.integer(3, 30),
                     random.integer(3, 20)};
    const double distance = random.chance(0.2) ? -1e-9 : random.real(0.05, 0.3);
    World world(dims, 0.1, 0.0);
    const std::vector<Vec3> hull = random_hull(random, {0.1 * dims.x, 0.1 * dims.y, 0.1 * dims.z});
    const Polyhedron hints = random_hints(random);
    for (int k = random.integer(1, 60); k > 0; --k) {
      const Voxel v{random.integer(0, dims.x - 1), random.integer(0, dims.y - 1), random.integer(0, dims.z - 1)};
      if (random.chance(0.02) || kept_by(world, hull, hints, v) > distance) world.grid.mark_voxel(v);
    }
    const double least = least_kept(world, hull, hints);
    if (std::fabs(least - distance) < 1e-10) continue;  // a tie
    ASSERT_EQ(is_cut_off(world, hull, hints, distance), least > distance) << i << ' ' << least;
    (least > distance ? clear : touched) += 1;
  }
  EXPECT_GT(clear, scaled(1500) / 4);
  EXPECT_GT(touched, scaled(1500) / 20);
}

TEST(CutOff, SeesOneVoxelThatAPlaneJustMisses) {
  Random random(42);
  for (int i = 0; i < scaled(500); ++i) {
    World world({70, 20, 12}, 0.1, 0.2);
    const Voxel v{random.integer(20, 69), random.integer(0, 19), random.integer(0, 11)};
    world.grid.mark_voxel(v);
    Vec3 n{random.real(0.1, 1.0), random.real(0.1, 1), random.real(0.1, 1)};
    const double length = std::sqrt(dot_of(n, n));
    n = {n.x / length, n.y / length, n.z / length};
    Polyhedron hints{};
    hints.count = 1;
    hints.planes[0] = {n, 0.0};
    const auto at = [&](double distance) {
      return std::vector<Vec3>{{0.1 * v.x - distance * n.x, 0.1 * v.y - distance * n.y, 0.1 * v.z - distance * n.z}};
    };
    EXPECT_TRUE(is_cut_off(world, at(0.2 + 1e-9), hints, 0.2)) << i;
    EXPECT_FALSE(is_cut_off(world, at(0.2 - 2e-7), hints, 0.2)) << i;
  }
}

/// Too many rows for one look: the answer is no, and the curve is halved.
TEST(CutOff, LeavesWideHullsAlone) {
  World world({20, 200, 200}, 0.1, 0.2);
  tern::Work work;
  const Vec3 wide[] = {{1.0, 1.0, 1.0}, {1.0, 19.0, 19.0}};
  EXPECT_FALSE(tern::cut_off(world.grid, wide, 2, {nullptr, 0}, 0.2, work));
  const Vec3 half[] = {{1.0, 1.0, 1.0}, {1.0, 10.0, 10.0}};
  EXPECT_TRUE(tern::cut_off(world.grid, half, 2, {nullptr, 0}, 0.2, work));
}

}  // namespace
}  // namespace tern_test
