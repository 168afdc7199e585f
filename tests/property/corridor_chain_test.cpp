// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Corridors along random polylines: neighbours share a ball of stated radius around their common point.
#include <gtest/gtest.h>

#include <memory>

#include "corridor/corridor_stage.hpp"
#include "support/corridor_reference.hpp"
#include "support/random.hpp"

namespace tern_test {
namespace {

using tern::Box;
using tern::Corridor;
using tern::CorridorStage;
using tern::Halfspace;
using tern::Path;
using tern::Polyhedron;
using tern::Status;
using tern::Vec3;
using tern::Work;

/// Extends a path through random points while its legs keep `clearance` from the cubes and the boundary's faces.
void random_path(Random& random, const World& world, const std::vector<Box>& cubes, double clearance, Path& path) {
  const Box b = world.grid.local_boundary();
  path.count = 0;
  for (int tries = 0; tries < 40 && path.count < 6; ++tries) {
    const Vec3 p{random.real(b.lower.x + clearance, b.upper.x - clearance),
                 random.real(b.lower.y + clearance, b.upper.y - clearance),
                 random.real(b.lower.z + clearance, b.upper.z - clearance)};
    const Vec3 from = path.count == 0 ? p : path.points[path.count - 1];
    if (segment_clearance(from, p, cubes, 1e9) < world.grid.spec().radius + clearance) continue;
    path.points[path.count++] = p;
  }
}

void expect_ball(const Polyhedron& polyhedron, const Vec3& center, double radius) {
  for (int p = 0; p < polyhedron.count; ++p) ASSERT_LE(signed_excess(polyhedron.planes[p], center), -radius + 1e-9);
}

TEST(CorridorChain, NeighboursShareABallAroundTheirPoint) {
  Random random(31);
  const auto stage = std::make_unique<CorridorStage>();
  const auto path = std::make_unique<Path>();
  const auto corridor = std::make_unique<Corridor>();
  int joints = 0;
  for (int i = 0; i < scaled(400); ++i) {
    const double cell = random.chance(0.5) ? 0.1 : 0.25;
    const double radius = random.chance(0.3) ? 0.0 : random.real(0.0, 0.3);
    World world({random.integer(10, 60), random.integer(10, 40), random.integer(8, 20)}, cell, radius);
    const tern::Voxel dims = world.grid.spec().dims;
    const int obstacles = random.integer(0, 40);
    for (int k = 0; k < obstacles; ++k) {
      const tern::Voxel v{random.integer(0, dims.x - 1), random.integer(0, dims.y - 1), random.integer(0, dims.z - 1)};
      const int size = random.integer(1, 4);
      world.fill(v, {std::min(v.x + size, dims.x), std::min(v.y + size, dims.y), std::min(v.z + 2 * size, dims.z)});
    }
    const std::vector<Box> cubes = obstacle_cubes(world.grid);
    const double ball = tern::kSightMargin * cell;
    random_path(random, world, cubes, ball, *path);
    if (path->count < 2) continue;
    corridor_begin(*stage, world.grid, *path, 0xFFFFFFFFu);
    Work work{0xFFFFFFFFu};
    ASSERT_EQ(corridor_advance(*stage, world.grid, *path, work, *corridor), Status::kOk) << "case " << i;
    SCOPED_TRACE(i);
    for (int k = 0; k < corridor->count; ++k) {
      ASSERT_NO_FATAL_FAILURE(expect_ball(corridor->polyhedra[k], corridor->polyhedra[k].from, ball));
      ASSERT_NO_FATAL_FAILURE(expect_ball(corridor->polyhedra[k], corridor->polyhedra[k].to, ball));
      ASSERT_NO_FATAL_FAILURE(expect_clear(corridor->polyhedra[k], cubes, radius, random));
      if (k > 0) ++joints;
    }
  }
  EXPECT_GT(joints, scaled(400));
}

}  // namespace
}  // namespace tern_test
