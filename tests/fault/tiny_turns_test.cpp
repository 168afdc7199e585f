// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Paths with more turns than the tiny profile has jump points for: of one search, and of a way's legs together.
#include <gtest/gtest.h>

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
    const std::uint32_t expansions = runner.search().expansions;
    EXPECT_EQ(runner.search().raw_high, tern::kMaxJumpPoints);
    EXPECT_EQ(runner.run(world.grid, query, 1), Status::kJumpPointsFull);
    EXPECT_EQ(runner.search().expansions, expansions);
  }
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
    EXPECT_EQ(world.report.high_water.jump_points, tern::kMaxJumpPoints);
    EXPECT_TRUE(world.trajectory_untouched());
    world.request.via_count = 0;
    EXPECT_EQ(world.plan(), Status::kOk);
  }
  EXPECT_GT(full, 0);
}

}  // namespace
