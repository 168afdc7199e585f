// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The reach stage against a flood of single voxels and a look at every voxel that it reached.
#include <gtest/gtest.h>

#include <deque>

#include "grid/distance.hpp"
#include "path/reach_stage.hpp"
#include "support/at_once.hpp"
#include "support/walled_world.hpp"

namespace tern_test {
namespace {

using tern::Progress;
using tern::Status;
using tern::Vec3;
using tern::Voxel;

constexpr std::uint32_t kAll = 0xFFFFFFFFu;

/// Runs the stage in memory that starts as garbage.
class Runner {
 public:
  Runner() : stage_(new tern::ReachStage) { std::memset(static_cast<void*>(stage_.get()), 0xA5, sizeof *stage_); }

  Progress run(const tern::Grid& grid, const Vec3& start, const Vec3& goal, std::uint32_t slice = kAll) {
    tern::reach_begin(*stage_, tern::World(grid), {start, goal});
    for (;;) {
      tern::Work work{slice};
      const Progress progress = tern::reach_advance(*stage_, tern::World(grid), work);
      if (progress != Progress::kMore) return progress;
      EXPECT_FALSE(work.left());
    }
  }
  const tern::ReachStage& stage() const { return *stage_; }

 private:
  std::unique_ptr<tern::ReachStage> stage_;
};

/// The nearest voxel to the goal, by brute force; all coordinates are multiples of 1/4, so that distances are exact.
class Reference {
 public:
  Reference(const tern::Grid& grid, const Vec3& start) : grid_(grid), reached_(count(), false) {
    const Voxel home = grid.voxel_of(start);
    // The start joins its own voxel. Without a radius it joins others only where they contain it, on a line that is
    // clear.
    for (int dz = -1; dz <= 1; ++dz) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) join(start, {home.x + dx, home.y + dy, home.z + dz}, home);
      }
    }
    while (!open_.empty()) {
      const Voxel v = open_.front();
      open_.pop_front();
      for (const Voxel& d : {Voxel{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) reach(v + d);
    }
  }

  bool any() const { return any_; }
  bool reached(const Voxel& v) const { return reached_[index(v)]; }

  Voxel nearest(const Vec3& goal) const {
    const Voxel dims = grid_.spec().dims;
    Voxel best{-1, -1, -1};
    double least = 1e300;
    for (int z = 0; z < dims.z; ++z) {
      for (int y = 0; y < dims.y; ++y) {
        for (int x = 0; x < dims.x; ++x) {
          const Vec3 d = grid_.center({x, y, z}) - goal;
          const double squared = d.x * d.x + d.y * d.y + d.z * d.z;
          if (!reached({x, y, z}) || !(squared < least)) continue;
          least = squared;
          best = {x, y, z};
        }
      }
    }
    return best;
  }

 private:
  std::size_t count() const {
    const Voxel dims = grid_.spec().dims;
    return static_cast<std::size_t>(dims.x * dims.y * dims.z);
  }
  std::size_t index(const Voxel& v) const {
    const Voxel dims = grid_.spec().dims;
    return static_cast<std::size_t>(v.x + dims.x * (v.y + dims.y * v.z));
  }
  void reach(const Voxel& v) {
    if (!grid_.free(v) || reached_[index(v)]) return;
    reached_[index(v)] = any_ = true;
    open_.push_back(v);
  }
  void join(const Vec3& start, const Voxel& v, const Voxel& home) {
    const Vec3 c = grid_.center(v);
    const bool beside =
        std::fabs(c.x - start.x) <= 0.5 && std::fabs(c.y - start.y) <= 0.5 && std::fabs(c.z - start.z) <= 0.5;
    const bool own = v.x == home.x && v.y == home.y && v.z == home.z;
    if (own || (beside && grid_.free(v) && tern::segment_clear(grid_, start, c, 0.0))) reach(v);
  }

  const tern::Grid& grid_;
  std::vector<bool> reached_;
  std::deque<Voxel> open_;
  bool any_ = false;
};

Vec3 random_quarters(Random& random, const Voxel& dims) {
  return {random.integer(0, 4 * dims.x) / 4.0, random.integer(0, 4 * dims.y) / 4.0,
          random.integer(0, 4 * dims.z) / 4.0};
}

TEST(PathReach, FindsTheNearestVoxelThatAFloodReaches) {
  Random random(16);
  Runner runner;
  int met = 0;
  int apart = 0;
  for (int k = 0; k < scaled(400); ++k) {
    const VoxelWorld world = walled_world(random);
    const Voxel dims = world.grid.spec().dims;
    for (int q = 0; q < 4; ++q) {
      Voxel from{};
      if (!random_free(world.grid, random, from)) continue;
      // On a corner or a face now and then: the start may join voxels on either side.
      const Vec3 start = random.chance(0.5) ? world.grid.center(from) : Vec3{from.x * 1.0, from.y + 0.5, from.z * 1.0};
      const Vec3 goal = random_quarters(random, dims);
      const Reference reference(world.grid, start);
      ASSERT_TRUE(reference.any());
      ASSERT_EQ(runner.run(world.grid, start, goal), Progress::kDone);
      const tern::ReachStage& stage = runner.stage();
      const Voxel expected = reference.nearest(goal);
      ASSERT_TRUE(tern::same(stage.nearest, expected)) << "case " << k << ", " << q;
      Voxel best{};
      ASSERT_TRUE(tern_test::nearest_free_voxel(world.grid, goal, best));
      ++(tern::same(best, expected) ? met : apart);
    }
  }
  EXPECT_GT(met, scaled(400) / 4);
  EXPECT_GT(apart, scaled(400) / 4);
}

TEST(PathReach, SlicesDoNotChangeTheAnswer) {
  Random random(17);
  Runner whole;
  Runner sliced;
  for (int k = 0; k < scaled(100); ++k) {
    const VoxelWorld world = walled_world(random);
    Voxel from{};
    if (!random_free(world.grid, random, from)) continue;
    const Vec3 start = world.grid.center(from);
    const Vec3 goal = random_quarters(random, world.grid.spec().dims);
    ASSERT_EQ(whole.run(world.grid, start, goal), Progress::kDone);
    ASSERT_EQ(sliced.run(world.grid, start, goal, static_cast<std::uint32_t>(random.integer(1, 9))), Progress::kDone);
    EXPECT_TRUE(tern::same(sliced.stage().nearest, whole.stage().nearest));
  }
}

TEST(PathReach, AStartThatJoinsNothingReachesNothing) {
  VoxelWorld world({8, 8, 8});
  world.block({2, 2, 2}, {4, 4, 4});
  Runner runner;
  EXPECT_EQ(runner.run(world.grid, {3.5, 3.5, 3.5}, {7.5, 7.5, 7.5}), Progress::kFailed);
  EXPECT_EQ(runner.stage().status, Status::kStartOccupied);
  world.block({0, 0, 0}, {7, 7, 7});
  EXPECT_EQ(runner.run(world.grid, {0.5, 0.5, 0.5}, {7.5, 7.5, 7.5}), Progress::kFailed);
  EXPECT_EQ(runner.stage().status, Status::kStartOccupied);
}

}  // namespace
}  // namespace tern_test
