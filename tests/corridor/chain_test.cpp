// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Corridors along random polylines and along paths of the path stage: no cube inside, joints at
// waypoints, neighbours share a ball of stated radius around their common point.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "corridor/corridor_stage.hpp"
#include "corridor/separation.hpp"
#include "path/sight.hpp"
#include "path/tighten.hpp"
#include "support/corridor_reference.hpp"
#include "support/path_world.hpp"
#include "support/random.hpp"

namespace tern_test {
namespace {

using tern::Box;
using tern::Corridor;
using tern::CorridorStage;
using tern::Path;
using tern::Polyhedron;
using tern::Status;
using tern::Vec3;
using tern::Voxel;
using tern::Work;

/// What the docs promise, in voxels: every joint has the first; legs that keep kTightenMargin have the second at their
/// own ends, half of the room there is.
constexpr double kBall = 0.05;
constexpr double kTightenedBall = 0.075;
static_assert(tern::kSightMargin >= kBall, "docs/corridor.md states the radius of the overlap");
static_assert(tern::kTightenMargin * tern::kMarginShare >= kTightenedBall - 1e-12, "as above");

/// Extends a path through random points while its legs keep `clearance` from the cubes and the boundary's faces.
void random_path(Random& random, const MarkedWorld& world, const std::vector<Box>& cubes, double clearance,
                 Path& path) {
  const Box b = world.grid.local_boundary();
  path.count = 0;
  for (int tries = 0; tries < 40 && path.count < 6; ++tries) {
    const Vec3 p{random.real(b.lower.x + clearance, b.upper.x - clearance),
                 random.real(b.lower.y + clearance, b.upper.y - clearance),
                 random.real(b.lower.z + clearance, b.upper.z - clearance)};
    const Vec3 from = path.count == 0 ? p : path.points[path.count - 1];
    const double least = world.grid.spec().radius + clearance;
    if (segment_clearance(from, p, cubes, least) < least) continue;
    path.points[path.count++] = p;
  }
}

MarkedWorld random_cuboids(Random& random) {
  const double cell = random.chance(0.5) ? 0.1 : 0.25;
  const double radius = random.chance(0.3) ? 0.0 : random.real(0.0, 0.3);
  MarkedWorld world({random.integer(10, 60), random.integer(10, 40), random.integer(8, 20)}, cell, radius);
  const Voxel dims = world.grid.spec().dims;
  const int obstacles = random.integer(0, 40);
  for (int k = 0; k < obstacles; ++k) {
    const Voxel v{random.integer(0, dims.x - 1), random.integer(0, dims.y - 1), random.integer(0, dims.z - 1)};
    const int size = random.integer(1, 4);
    world.fill(v, {std::min(v.x + size, dims.x), std::min(v.y + size, dims.y), std::min(v.z + 2 * size, dims.z)});
  }
  return world;
}

bool holds_ball(const Polyhedron& polyhedron, const Vec3& center, double radius) {
  for (int p = 0; p < polyhedron.count; ++p) {
    if (signed_excess(polyhedron.planes[p], center) > -radius + 1e-9) return false;
  }
  return true;
}

/// From one end of the path to the other without a gap, with the ball about every joint.
void expect_joints(const Path& path, const Corridor& corridor, double ball) {
  ASSERT_TRUE(same(corridor.polyhedra[0].from, path.points[0]));
  ASSERT_TRUE(same(corridor.polyhedra[corridor.count - 1].to, path.points[path.count - 1]));
  for (int k = 0; k < corridor.count; ++k) {
    if (k > 0) {
      ASSERT_TRUE(same(corridor.polyhedra[k].from, corridor.polyhedra[k - 1].to));
    }
    ASSERT_TRUE(holds_ball(corridor.polyhedra[k], corridor.polyhedra[k].from, ball)) << k;
    ASSERT_TRUE(holds_ball(corridor.polyhedra[k], corridor.polyhedra[k].to, ball)) << k;
  }
}

/// Joints are waypoints, in the path's order, up to the first leg that is cut into pieces.
void expect_joints_on(const Path& path, const Corridor& corridor) {
  int waypoint = 0;
  for (int k = 0; k < corridor.count; ++k) {
    do {
      ++waypoint;
      ASSERT_LT(waypoint, path.count) << "polyhedron " << k << " ends at no waypoint";
      if (norm3(minus3(path.points[waypoint], path.points[waypoint - 1])) > tern::kLongLeg) return;
    } while (!same(corridor.polyhedra[k].to, path.points[waypoint]));
  }
}

class CorridorChain : public ::testing::Test {
 protected:
  Status run(const tern::Grid& grid, const Path& path) {
    corridor_begin(*stage_, path);
    Work work{0xFFFFFFFFu};
    corridor_advance(*stage_, tern::World(grid), path, work, *corridor_);
    return stage_->status;
  }

  void expect_sound(const tern::Grid& grid, const std::vector<Box>& cubes) {
    for (int k = 0; k < corridor_->count; ++k) {
      const Polyhedron& polyhedron = corridor_->polyhedra[k];
      ASSERT_NO_FATAL_FAILURE(expect_clear(polyhedron, cubes, grid.spec().radius, random_));
      ASSERT_NO_FATAL_FAILURE(expect_no_redundancy(polyhedron));
      for (int p = 0; p < polyhedron.count; ++p) {
        ASSERT_NEAR(norm3(polyhedron.planes[p].normal), 1.0, 1e-12);
      }
    }
  }

  Random random_{31};
  std::unique_ptr<CorridorStage> stage_ = std::make_unique<CorridorStage>();
  std::unique_ptr<Path> path_ = std::make_unique<Path>();
  std::unique_ptr<Corridor> corridor_ = std::make_unique<Corridor>();
};

TEST_F(CorridorChain, NeighboursShareABallAroundTheirPoint) {
  int joints = 0;
  int shared = 0;
  for (int i = 0; i < scaled(2000); ++i) {
    const MarkedWorld world = random_cuboids(random_);
    const std::vector<Box> cubes = obstacle_cubes(world.grid);
    const double ball = kBall * world.grid.spec().cell;
    random_path(random_, world, cubes, ball, *path_);
    if (path_->count < 2) continue;
    ASSERT_EQ(run(world.grid, *path_), Status::kOk) << "case " << i;
    SCOPED_TRACE(i);
    ASSERT_NO_FATAL_FAILURE(expect_joints(*path_, *corridor_, ball));
    ASSERT_NO_FATAL_FAILURE(expect_joints_on(*path_, *corridor_));
    if (i % 5 == 0) {
      ASSERT_NO_FATAL_FAILURE(expect_sound(world.grid, cubes));
    }
    joints += corridor_->count - 1;
    if (corridor_->count < path_->count - 1) ++shared;
  }
  EXPECT_GT(joints, scaled(2000));
  EXPECT_GT(shared, scaled(100)) << "corridors where a polyhedron serves two legs";
}

/// Pillars from the ground up or from the ceiling down.
VoxelWorld random_pillars(Random& random) {
  const double cell = random.chance(0.5) ? 0.1 : 0.25;
  const double radius = random.chance(0.5) ? 0.0 : random.real(0.0, 0.2);
  VoxelWorld world({random.integer(12, 40), random.integer(12, 30), random.integer(6, 14)}, cell, radius);
  const Box all = world.grid.local_boundary();
  for (int k = random.integer(5, 30); k > 0; --k) {
    const Vec3 p{random.real(0.0, all.upper.x), random.real(0.0, all.upper.y), random.real(0.0, all.upper.z)};
    const bool stands = random.chance(0.7);
    const Vec3 q{p.x + random.real(0.0, 4.0 * cell), p.y + random.real(0.0, 6.0 * cell), stands ? p.z : all.upper.z};
    world.grid.mark_box({{p.x, p.y, stands ? 0.0 : p.z}, q});
  }
  world.grid.inflate();
  return world;
}

/// The polyhedron's segment is a leg of the path, whole.
bool is_leg(const Path& path, const Polyhedron& polyhedron) {
  for (int leg = 0; leg + 1 < path.count; ++leg) {
    if (same(path.points[leg], polyhedron.from) && same(path.points[leg + 1], polyhedron.to)) return true;
  }
  return false;
}

TEST_F(CorridorChain, PathsOfThePathStageHaveTheStatedBalls) {
  PathRunner runner;
  int joints = 0;
  int tightened = 0;
  for (int i = 0; i < scaled(4000); ++i) {
    const VoxelWorld world = random_pillars(random_);
    const double cell = world.grid.spec().cell;
    Voxel start{};
    Voxel goal{};
    if (!random_free(world.grid, random_, start) || !random_free(world.grid, random_, goal)) continue;
    if (runner.run(world.grid, start, goal) != Status::kOk) continue;
    const Path& path = runner.path();
    ASSERT_EQ(run(world.grid, path), Status::kOk) << "case " << i;
    SCOPED_TRACE(i);
    ASSERT_NO_FATAL_FAILURE(expect_joints(path, *corridor_, kBall * cell));
    ASSERT_NO_FATAL_FAILURE(expect_joints_on(path, *corridor_));
    for (int k = 0; k < corridor_->count; ++k) {
      const Polyhedron& polyhedron = corridor_->polyhedra[k];
      joints += k > 0 ? 1 : 0;
      if (!is_leg(path, polyhedron)) continue;
      if (!line_of_sight(world.grid, polyhedron.from, polyhedron.to, tern::kTightenMargin)) continue;
      ASSERT_TRUE(holds_ball(polyhedron, polyhedron.from, kTightenedBall * cell)) << k;
      ASSERT_TRUE(holds_ball(polyhedron, polyhedron.to, kTightenedBall * cell)) << k;
      ++tightened;
    }
  }
  EXPECT_GT(joints, scaled(2000));
  EXPECT_GT(tightened, scaled(2000));
}

}  // namespace
}  // namespace tern_test
