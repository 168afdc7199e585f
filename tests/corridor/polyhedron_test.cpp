// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Polyhedra in thousands of random worlds, held against brute force over every voxel.
#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "corridor/grow.hpp"
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
using tern::Voxel;

void add_noise(MarkedWorld& world, Random& random, double density) {
  const Voxel dims = world.grid.spec().dims;
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int x = 0; x < dims.x; ++x) {
        if (random.chance(density)) world.mark(x, y, z);
      }
    }
  }
}

void add_cuboids(MarkedWorld& world, Random& random, int count) {
  const Voxel dims = world.grid.spec().dims;
  for (int i = 0; i < count; ++i) {
    const Voxel lower{random.integer(0, dims.x - 1), random.integer(0, dims.y - 1), random.integer(0, dims.z - 1)};
    const Voxel upper{std::min(dims.x, lower.x + random.integer(1, 6)),
                      std::min(dims.y, lower.y + random.integer(1, 6)),
                      std::min(dims.z, lower.z + random.integer(1, 6))};
    world.fill(lower, upper);
  }
}

/// Solid but for a tunnel of one to three voxels along an axis.
void add_tunnel(MarkedWorld& world, Random& random) {
  const Voxel dims = world.grid.spec().dims;
  world.fill({0, 0, 0}, dims);
  const int along = random.integer(0, 2);
  const int width = random.integer(1, 3);
  const int a = random.integer(0, 3);
  const int b = random.integer(0, 3);
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int x = 0; x < dims.x; ++x) {
        const int v[3] = {x, y, z};
        const int u = v[(along + 1) % 3];
        const int w = v[(along + 2) % 3];
        if (u >= a && u < a + width && w >= b && w < b + width) world.clear(x, y, z);
      }
    }
  }
}

Vec3 random_point(Random& random, const Box& box) {
  return {random.real(box.lower.x, box.upper.x), random.real(box.lower.y, box.upper.y),
          random.real(box.lower.z, box.upper.z)};
}

Box random_boundary(Random& random, const Voxel& dims, double cell) {
  Box boundary{{0.0, 0.0, 0.0}, {dims.x * cell, dims.y * cell, dims.z * cell}};
  if (random.chance(0.5)) return boundary;
  boundary.lower = {random.real(0.0, cell), random.real(0.0, cell), random.real(0.0, cell)};
  boundary.upper = {boundary.upper.x - random.real(0.0, 2.0 * cell), boundary.upper.y - random.real(0.0, 2.0 * cell),
                    boundary.upper.z - random.real(0.0, 2.0 * cell)};
  return boundary;
}

MarkedWorld crowded_world(Random& random) {
  const double cells[] = {0.05, 0.1, 0.3, 1.0};
  const double cell = cells[random.integer(0, 3)];
  const double radius = random.chance(0.4) ? 0.0 : random.real(0.0, 3.0) * cell;
  const Voxel dims{random.integer(4, 20), random.integer(4, 16), random.integer(4, 10)};
  MarkedWorld world(dims, cell, radius, random_boundary(random, dims, cell));
  const int kind = random.integer(0, 9);
  if (kind < 4) add_cuboids(world, random, random.integer(1, 12));
  if (kind >= 4 && kind < 8) add_noise(world, random, random.real(0.0, 0.05));
  if (kind == 8) add_noise(world, random, random.real(0.05, 0.3));
  if (kind == 9) add_tunnel(world, random);
  return world;
}

/// Well inside an obstacle somewhere: what a distance of 0 does not tell from a touch.
bool pierces(const Vec3& from, const Vec3& to, const std::vector<Box>& cubes) {
  for (int i = 0; i <= 50; ++i) {
    const Vec3 p = mix3(from, to, i / 50.0);
    for (const Box& c : cubes) {
      const double depth = std::min(
          {p.x - c.lower.x, c.upper.x - p.x, p.y - c.lower.y, c.upper.y - p.y, p.z - c.lower.z, c.upper.z - p.z});
      if (depth > 1e-6) return true;
    }
  }
  return false;
}

TEST(CorridorPolyhedron, IsClearOfEveryCubeAndHoldsItsSegment) {
  Random random(20260701);
  const auto scratch = std::make_unique<GrowScratch>();
  const auto polyhedron = std::make_unique<Polyhedron>();
  int grown = 0;
  int blocked = 0;
  const int wanted = scaled(6000);
  for (int i = 0; i < wanted * 10 && grown < wanted; ++i) {
    const MarkedWorld world = crowded_world(random);
    const std::vector<Box> cubes = obstacle_cubes(world.grid);
    const Vec3 from = random_point(random, world.grid.local_boundary());
    const Vec3 far = random_point(random, world.grid.local_boundary());
    const Vec3 to = mix3(from, far, random.chance(0.1) ? 0.0 : random.unit());
    const double clearance = segment_clearance(from, to, cubes, 1e9);
    const double radius = world.grid.spec().radius;
    reset_counters(*scratch);
    const Status status = tern_test::grow_polyhedron(tern::World(world.grid), from, to, *scratch, *polyhedron);
    if (clearance < radius - 1e-7) {
      ASSERT_EQ(status, Status::kCorridorBlocked) << "case " << i;
      ++blocked;
      continue;
    }
    if (pierces(from, to, cubes)) {
      ASSERT_EQ(status, Status::kCorridorBlocked) << "case " << i;
      ++blocked;
      continue;
    }
    if (clearance < radius + 1e-7) continue;  // a touch, within what the reference resolves
    ASSERT_TRUE(status == Status::kOk || status == Status::kPlanesFull) << "case " << i;
    if (status != Status::kOk) continue;
    ++grown;
    SCOPED_TRACE(i);
    ASSERT_NO_FATAL_FAILURE(expect_clear(*polyhedron, cubes, radius, random));
    ASSERT_NO_FATAL_FAILURE(expect_holds_segment(world.grid, *polyhedron, clearance));
    ASSERT_NO_FATAL_FAILURE(expect_no_redundancy(*polyhedron));
  }
  EXPECT_EQ(grown, wanted);
  EXPECT_GT(blocked, 0);
}

TEST(CorridorPolyhedron, DoesNotDependOnWhatTheScratchHeld) {
  Random random(7);
  const auto scratch = std::make_unique<GrowScratch>();
  const auto first = std::make_unique<Polyhedron>();
  const auto second = std::make_unique<Polyhedron>();
  for (int i = 0; i < scaled(300); ++i) {
    const MarkedWorld world = crowded_world(random);
    const Vec3 from = random_point(random, world.grid.local_boundary());
    const Vec3 to = random_point(random, world.grid.local_boundary());
    std::memset(static_cast<void*>(scratch.get()), 0xA5, sizeof *scratch);
    std::memset(static_cast<void*>(first.get()), 0, sizeof *first);
    reset_counters(*scratch);
    const Status a = tern_test::grow_polyhedron(tern::World(world.grid), from, to, *scratch, *first);
    std::memset(static_cast<void*>(scratch.get()), 0, sizeof *scratch);
    std::memset(static_cast<void*>(second.get()), 0, sizeof *second);
    reset_counters(*scratch);
    const Status b = tern_test::grow_polyhedron(tern::World(world.grid), from, to, *scratch, *second);
    ASSERT_EQ(a, b);
    if (a != Status::kOk) continue;
    ASSERT_EQ(first->count, second->count);
    const std::size_t bytes = sizeof(tern::Halfspace) * static_cast<std::size_t>(first->count);
    ASSERT_EQ(std::memcmp(first->planes, second->planes, bytes), 0);
  }
}

}  // namespace
}  // namespace tern_test
