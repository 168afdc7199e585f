// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Paths with more turns than the tiny profile has jump points for: of one search, and of a way's legs together.
#include <gtest/gtest.h>

#include <memory>

#include "guide/voxel_search.hpp"
#include "support/path_world.hpp"
#include "support/world.hpp"

namespace {

using tern::SearchMode;
using tern::Status;
using tern::Vec3;
using tern_test::PathQuery;
using tern_test::Random;
using tern_test::VoxelWorld;

/// A tunnel in steps: it turns in each voxel.
TEST(TinyTurns, AStaircaseIsFullWhicheverSearchTakesIt) {
  VoxelWorld world({32, 32, 1});
  world.block({0, 0, 0}, {31, 31, 0});
  for (int k = 0; k < 20; ++k) world.clear({k, k, 0}).clear({k + 1, k, 0});
  PathQuery query{{0.5, 0.5, 0.5}, {20.5, 19.5, 0.5}};
  tern_test::PathRunner runner;
  for (const SearchMode mode : {SearchMode::kOptimal, SearchMode::kFast}) {
    query.search = mode;
    EXPECT_EQ(runner.run(world.grid, query), Status::kJumpPointsFull);
    const std::uint32_t expansions = runner.search().pieces;
    EXPECT_EQ(runner.search().raw_high, tern::kMaxJumpPoints);
    EXPECT_EQ(runner.run(world.grid, query, 1), Status::kJumpPointsFull);
    EXPECT_EQ(runner.search().pieces, expansions);
  }
}

/// A staircase of nine steps from (8, 8) to (17, 17), and noise on both sides that leads nowhere.
VoxelWorld staircase_in_noise(Random& random) {
  VoxelWorld world({20, 20, 1});
  world.block({0, 0, 0}, {19, 19, 0});
  const double density = random.real(0.5, 0.95);
  const int width = random.integer(2, 8);
  for (int y = 5; y < 17; ++y) {
    for (int x = 1; x < 18; ++x) {
      const bool right = x >= 8 && x - y >= 3 && x - y <= 3 + width;
      const bool left = y - x >= 2 && y - x <= 2 + width;
      if ((right || left) && random.chance(density)) world.grid.clear_voxel({x, y, 0});
    }
  }
  for (int k = 8; k <= 17; ++k) {
    world.grid.clear_voxel({k, k, 0});
    if (k < 17) world.grid.clear_voxel({k + 1, k, 0});
  }
  for (const tern::Voxel& way : {tern::Voxel{8, 7, 0}, {8, 6, 0}, {8, 5, 0}, {7, 8, 0}, {7, 9, 0}, {6, 9, 0}}) {
    world.grid.clear_voxel(way);
  }
  world.grid.inflate();
  return world;
}

/// True if the fast search finds a path by the guide, and that has too many turns.
bool guided_path_is_full(const tern::Grid& grid, const PathQuery& query) {
  const auto search = std::make_unique<tern::VoxelSearch>();
  const auto path = std::make_unique<tern::Path>();
  tern::voxel_search_begin(*search, grid, grid.voxel_of(query.start), grid.voxel_of(query.goal), SearchMode::kFast);
  tern::Work work{0xFFFFFFFFu};
  if (tern::voxel_search_advance(*search, grid, work) != Status::kOk) return false;
  path->raw_count = 0;
  const bool full = tern::voxel_search_extract(*search, grid, 0, *path) == Status::kJumpPointsFull;
  return full && search->method == tern::SearchMethod::kGuided;
}

/// The optimal search, which answers then, has too many turns or too many nodes.
TEST(TinyTurns, WhereTheGuidedPathIsFullTheOptimalSearchAnswers) {
  Random random(73);
  tern_test::PathRunner fast;
  tern_test::PathRunner optimal;
  int full = 0;
  for (int k = 0; k < 6000 && full < 5; ++k) {
    const VoxelWorld world = staircase_in_noise(random);
    PathQuery query{{8.5, 8.5, 0.5}, {17.5, 17.5, 0.5}};
    query.search = SearchMode::kFast;
    if (!guided_path_is_full(world.grid, query)) continue;
    ++full;
    const Status answer = fast.run(world.grid, query);
    const std::uint32_t expansions = fast.search().pieces;
    EXPECT_EQ(fast.run(world.grid, query, 1), answer) << k;
    EXPECT_EQ(fast.search().pieces, expansions) << k;
    query.search = SearchMode::kOptimal;
    EXPECT_EQ(optimal.run(world.grid, query), answer) << k;
    EXPECT_TRUE(answer == Status::kJumpPointsFull || answer == Status::kNodesFull) << k;
    EXPECT_GT(expansions, optimal.search().pieces) << k;
  }
  EXPECT_GT(full, 0);
}

/// Through a hole in a wall and back again, between points beside the voxels' centres: each leg alone has fewer jump
/// points than there may be.
TEST(TinyTurns, LegsThatAreFullTogether) {
  Random random(74);
  int full = 0;
  for (int k = 0; k < 200 && full == 0; ++k) {
    tern_test::World world({20, 16, 12}, 0.25, 0.0);
    const int y = random.integer(1, 14);
    const int z = random.integer(1, 10);
    for (int v = 0; v < 12; ++v) {
      for (int u = 0; u < 16; ++u) {
        if (u != y || v != z) world.grid.mark_voxel({10, u, v});
      }
    }
    const auto beside = [&](double from, double to) {
      return Vec3{random.real(from, to), random.real(0.1, 3.9), random.real(0.1, 2.9)};
    };
    world.from(beside(0.1, 2.2)).to(beside(0.1, 2.2));
    tern::Via via{};
    via.position = beside(2.9, 4.9);
    world.request.vias = &via;
    world.request.via_count = 1;
    if (world.plan() != Status::kJumpPointsFull || world.report.stage != tern::Stage::kShortcut) continue;
    ++full;
    EXPECT_EQ(world.report.diagnostics.high_water.jump_points, tern::kMaxJumpPoints);
    EXPECT_TRUE(world.trajectory_untouched());
    world.request.via_count = 0;
    EXPECT_EQ(world.plan(), Status::kOk);
  }
  EXPECT_GT(full, 0);
}

}  // namespace
