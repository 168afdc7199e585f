// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The shortcut's chain over many points, up to as many as there may be, against a search that asks for every line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include "path/shortcut.hpp"
#include "path/sight.hpp"
#include "support/path_world.hpp"

namespace {

using tern::Path;
using tern::Shortcut;
using tern::Status;
using tern::Vec3;
using tern::Voxel;
using tern_test::between;
using tern_test::PathQuery;
using tern_test::PathRunner;
using tern_test::Random;
using tern_test::random_free;
using tern_test::random_world;
using tern_test::scaled;
using tern_test::VoxelWorld;

/// Fills path.raw with `count` steps from voxel to voxel through free space, each in sight of the next; shorter where
/// the walk is stuck.
void random_walk(const tern::Grid& grid, Random& random, Voxel at, int count, Path& path) {
  path.raw_count = 0;
  path.raw[path.raw_count++] = grid.center(at);
  for (int tries = 0; tries < 40 * count && path.raw_count < count; ++tries) {
    const Voxel to{at.x + random.integer(-1, 1), at.y + random.integer(-1, 1), at.z + random.integer(-1, 1)};
    if (!grid.free(to) || !tern::line_of_sight(grid, grid.center(at), grid.center(to))) continue;
    at = to;
    path.raw[path.raw_count++] = grid.center(at);
  }
}

/// Costs of the cheapest chains to all points, each leg from at most `window` points before (cell 1).
std::vector<double> cheapest_costs(const tern::Grid& grid, const Path& path, int window) {
  std::vector<double> costs(1, 0.0);
  for (int j = 1; j < path.raw_count; ++j) {
    double best = costs[j - 1] + (between(path.raw[j - 1], path.raw[j]) + tern::kLegPrice);
    for (int i = std::max(0, j - window); i + 1 < j; ++i) {
      const double cost = costs[i] + (between(path.raw[i], path.raw[j]) + tern::kLegPrice);
      if (cost < best && tern::line_of_sight(grid, path.raw[i], path.raw[j])) best = cost;
    }
    costs.push_back(best);
  }
  return costs;
}

/// The chain's cost, and the number of units it took.
struct Outcome {
  double cost;
  std::uint32_t units;
};

/// The chain from `path.raw`, its state moved to other memory full of garbage after every unit.
Outcome run_chain(const tern::Grid& grid, Path& path) {
  std::vector<Shortcut> memory(2);
  std::memset(static_cast<void*>(memory.data()), 0xA5, 2 * sizeof(Shortcut));
  tern::shortcut_begin(memory[0], grid, path);
  Outcome outcome{0.0, 0};
  for (; tern::shortcut_needs_step(memory[outcome.units % 2], path); ++outcome.units) {
    tern::shortcut_step(memory[outcome.units % 2], grid, path);
    memory[(outcome.units + 1) % 2] = memory[outcome.units % 2];
    std::memset(static_cast<void*>(&memory[outcome.units % 2]), 0xA5, sizeof(Shortcut));
  }
  outcome.cost = memory[outcome.units % 2].ends[path.raw_count - 1].cost;
  return outcome;
}

TEST(PathChain, AllPointsCountWhereThePathHasFewerThanTheWindow) {
  Random random(71);
  const std::unique_ptr<Path> path(new Path);
  for (int k = 0; k < scaled(1000); ++k) {
    const VoxelWorld world = random_world(random);
    Voxel start{};
    if (!random_free(world.grid, random, start)) continue;
    random_walk(world.grid, random, start, random.integer(2, tern::kSightWindow + 1), *path);
    if (path->raw_count < 2) continue;
    const Outcome outcome = run_chain(world.grid, *path);
    ASSERT_EQ(outcome.cost, cheapest_costs(world.grid, *path, tern::kMaxJumpPoints).back()) << "case " << k;
  }
}

TEST(PathChain, FullPathsStayWithinTheBound) {
  Random random(72);
  const std::unique_ptr<Path> path(new Path);
  int full = 0;
  for (int k = 0; k < scaled(60); ++k) {
    const VoxelWorld world = random_world(random);
    Voxel start{};
    if (!random_free(world.grid, random, start)) continue;
    random_walk(world.grid, random, start, tern::kMaxJumpPoints, *path);
    if (path->raw_count < 2) continue;
    full += path->raw_count == tern::kMaxJumpPoints ? 1 : 0;
    const Outcome outcome = run_chain(world.grid, *path);
    ASSERT_LE(outcome.units, tern::kChainBound);
    ASSERT_EQ(outcome.cost, cheapest_costs(world.grid, *path, tern::kSightWindow).back()) << "case " << k;
    ASSERT_LE(outcome.cost, path->raw_length + tern::kLegPrice * (path->raw_count - 1) + 1e-9);
  }
  EXPECT_GT(full, scaled(60) / 3);
}

/// A lane one voxel wide that winds through as many turns as a path may have.
VoxelWorld winding_lane(int columns) {
  VoxelWorld world({2 * columns, 3, 1});
  for (int k = 0; k < columns; ++k) {
    const int gap = k % 2 == 0 ? 2 : 0;
    world.grid.mark_voxel({2 * k + 1, 1, 0});
    world.grid.mark_voxel({2 * k + 1, 2 - gap, 0});
  }
  world.grid.inflate();
  return world;
}

TEST(PathChain, ALongWindingPathIsTheSameInSlices) {
  constexpr int kColumns = tern::kMaxJumpPoints / 2 - 1;
  const VoxelWorld world = winding_lane(kColumns);
  PathRunner whole;
  PathRunner sliced;
  const PathQuery query{world.grid.center({0, 0, 0}), world.grid.center({2 * kColumns - 2, 0, 0})};
  // More turns than a path may have segments: the chain is complete before that shows.
  ASSERT_EQ(whole.run(world.grid, query), Status::kSegmentsFull);
  EXPECT_GT(whole.path().raw_count, tern::kMaxJumpPoints * 9 / 10);
  EXPECT_LE(whole.shortcut().pieces, tern::kChainBound);
  for (const std::uint32_t slice : {1u, 7u, 1000u}) {
    ASSERT_EQ(sliced.run(world.grid, query, slice), Status::kSegmentsFull);
    EXPECT_EQ(sliced.shortcut().pieces, whole.shortcut().pieces);
    EXPECT_EQ(sliced.path().count, whole.path().count);
  }
}

}  // namespace
