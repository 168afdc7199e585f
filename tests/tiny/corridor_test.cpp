// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every capacity of the corridor stage overflows in the tiny configuration, each with its own status.
#include <gtest/gtest.h>

#include <memory>

#include "corridor/corridor_stage.hpp"
#include "support/corridor_reference.hpp"
#include "support/random.hpp"

namespace tern_test {
namespace {

using tern::Corridor;
using tern::CorridorStage;
using tern::GrowScratch;
using tern::Path;
using tern::Polyhedron;
using tern::Status;
using tern::Vec3;
using tern::Work;

class TinyCorridor : public ::testing::Test {
 protected:
  Status run(const MarkedWorld& world, std::initializer_list<Vec3> points) {
    path_->count = 0;
    for (const Vec3& p : points) path_->points[path_->count++] = p;
    corridor_begin(*stage_, *path_);
    Work work{0xFFFFFFFFu};
    const tern::Progress progress = corridor_advance(*stage_, tern::World(world.grid), *path_, work, *corridor_);
    EXPECT_NE(progress, tern::Progress::kMore);
    EXPECT_LE(stage_->tries, tern::kCorridorTries) << "more tries than the stated bound";
    const Status status = stage_->status;
    EXPECT_LE(stage_->planes_high, tern::kMaxPlanes);
    EXPECT_LE(stage_->boxes_high, tern::kMaxLocalBoxes);
    return status;
  }

  std::unique_ptr<CorridorStage> stage_ = std::make_unique<CorridorStage>();
  std::unique_ptr<Path> path_ = std::make_unique<Path>();
  std::unique_ptr<Corridor> corridor_ = std::make_unique<Corridor>();
};

/// A tube of eight pillars around a point's vertical line, as near as `gap` voxels: more planes than four.
void add_cage(MarkedWorld& world, int cx, int cy, int gap) {
  const int dims_z = world.grid.spec().dims.z;
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      if (dx == 0 && dy == 0) continue;
      const int x = cx + dx * gap;
      const int y = cy + dy * gap;
      for (int z = 0; z < dims_z; ++z) world.mark(x, y, z);
    }
  }
}

TEST_F(TinyCorridor, AFullBoxShrinksAndStillIsSafe) {
  // Scattered voxels: too many boxes within two metres, few enough within less.
  MarkedWorld world({40, 40, 16}, 0.1, 0.0);
  Random random(2);
  for (int i = 0; i < 120; ++i) {
    const int x = random.integer(0, 39);
    const int y = random.integer(0, 39);
    if (std::abs(x - 20) > 6 || std::abs(y - 20) > 6) world.mark(x, y, random.integer(0, 15));
  }
  ASSERT_EQ(run(world, {{2.0, 2.0, 0.8}, {2.2, 2.0, 0.8}}), Status::kOk);
  EXPECT_EQ(stage_->boxes_high, tern::kMaxLocalBoxes);
  const std::vector<tern::Box> cubes = obstacle_cubes(world.grid);
  for (int i = 0; i < corridor_->count; ++i) expect_clear(corridor_->polyhedra[i], cubes, 0.0, random);
}

TEST_F(TinyCorridor, TooManyBoxesEvenInTheSmallestBox) {
  // A three-dimensional checkerboard around a point's own voxel: every voxel is a box of its own.
  MarkedWorld world({16, 16, 16}, 0.1, 0.25);
  for (int z = 0; z < 16; ++z) {
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 16; ++x) {
        const int away = std::max({std::abs(x - 8), std::abs(y - 8), std::abs(z - 8)});
        if ((x + y + z) % 2 == 0 && away >= 3) world.mark(x, y, z);
      }
    }
  }
  EXPECT_EQ(run(world, {{0.85, 0.85, 0.85}, {0.85, 0.85, 0.85}}), Status::kObstaclesFull);
  EXPECT_EQ(stage_->boxes_high, tern::kMaxLocalBoxes);
}

TEST_F(TinyCorridor, TooManyPlanesShrinkTheBox) {
  MarkedWorld world({40, 40, 8}, 0.1, 0.0);
  add_cage(world, 20, 20, 8);
  ASSERT_EQ(run(world, {{2.05, 2.05, 0.4}, {2.05, 2.05, 0.4}}), Status::kOk);
  EXPECT_EQ(stage_->planes_high, tern::kMaxPlanes);
  EXPECT_LE(corridor_->polyhedra[0].count, tern::kMaxPlanes);
  Random random(3);
  expect_clear(corridor_->polyhedra[0], obstacle_cubes(world.grid), 0.0, random);
}

TEST_F(TinyCorridor, TooManyPlanesEvenForAPoint) {
  // Eight pillars that all come within the radius of the smallest box: a plane each, and four to give.
  MarkedWorld world({40, 40, 8}, 0.1, 0.19);
  add_cage(world, 20, 20, 3);
  for (int z = 0; z < 8; ++z) {
    for (int d = -3; d <= 3; d += 6) {
      world.clear(20 + d, 20 + d, z);
      world.clear(20 + d, 20 - d, z);
      world.mark(20 + d / 3 * 2, 20 + d / 3 * 2, z);
      world.mark(20 + d / 3 * 2, 20 - d / 3 * 2, z);
    }
  }
  EXPECT_EQ(run(world, {{2.05, 2.05, 0.4}, {2.05, 2.05, 0.4}}), Status::kPlanesFull);
  EXPECT_EQ(stage_->planes_high, tern::kMaxPlanes);
}

TEST_F(TinyCorridor, ACrowdedLegIsHalved) {
  // A leg past staggered posts on both sides: whole, it needs a plane for each; halved, two each.
  MarkedWorld world({64, 40, 8}, 0.1, 0.15);
  for (int k = 0; k < 6; ++k) {
    const int side = k % 2 == 0 ? 3 : -4;
    for (int z = 0; z < 8; ++z) world.mark(8 + 8 * k, 20 + side, z);
  }
  const Status status = run(world, {{0.5, 2.0, 0.4}, {5.5, 2.0, 0.4}});
  ASSERT_EQ(status, Status::kOk);
  Random random(4);
  const std::vector<tern::Box> cubes = obstacle_cubes(world.grid);
  for (int i = 0; i < corridor_->count; ++i) {
    expect_clear(corridor_->polyhedra[i], cubes, 0.15, random);
    if (i == 0) continue;
    EXPECT_EQ(norm3(minus3(corridor_->polyhedra[i].from, corridor_->polyhedra[i - 1].to)), 0.0);
  }
}

TEST_F(TinyCorridor, HalvingRunsOutOfSegments) {
  // A long tight lane of the checkerboard kind: no piece that four segments could be fits its boxes.
  MarkedWorld world({64, 16, 16}, 0.1, 0.25);
  for (int z = 0; z < 16; ++z) {
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 64; ++x) {
        const int away = std::max(std::abs(y - 8), std::abs(z - 8));
        if ((x + y + z) % 2 == 0 && away >= 3) world.mark(x, y, z);
      }
    }
  }
  EXPECT_EQ(run(world, {{0.5, 0.85, 0.85}, {5.5, 0.85, 0.85}}), Status::kSegmentsFull);
}

TEST_F(TinyCorridor, MoreLegsThanSegments) {
  const MarkedWorld world({40, 40, 8}, 0.1, 0.0);
  path_->count = tern::kMaxSegments + 2;  // what no shortcut stage hands over
  corridor_begin(*stage_, *path_);
  Work work{100};
  EXPECT_EQ(corridor_advance(*stage_, tern::World(world.grid), *path_, work, *corridor_), tern::Progress::kFailed);
  EXPECT_EQ(stage_->status, Status::kSegmentsFull);
}

TEST_F(TinyCorridor, ALongLegTakesNoMoreSegmentsThanThereAre) {
  const MarkedWorld world({64, 16, 8}, 1.0, 0.0);
  ASSERT_EQ(run(world, {{1.0, 8.0, 4.0}, {62.0, 8.0, 4.0}, {62.0, 15.0, 4.0}}), Status::kOk);
  EXPECT_EQ(corridor_->count, tern::kMaxSegments);
}

}  // namespace
}  // namespace tern_test
