// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The path stage with SearchMode::kFast against a plain A*: every verdict is right, and every bound holds.
#include <gtest/gtest.h>

#include "support/reference_search.hpp"
#include "support/walked_path.hpp"
#include "support/walled_world.hpp"

namespace {

using tern::SearchUsed;
using tern::Status;
using tern::Voxel;
using tern_test::PathRunner;
using tern_test::Random;
using tern_test::random_ends;
using tern_test::random_world;
using tern_test::ReferenceSearch;
using tern_test::scaled;
using tern_test::VoxelWorld;
using tern_test::walled_world;

tern_test::PathQuery fast_query(const VoxelWorld& world, const Voxel& start, const Voxel& goal) {
  tern_test::PathQuery query{world.grid.center(start), world.grid.center(goal)};
  query.search = tern::SearchMode::kFast;
  return query;
}

TEST(FastPath, VerdictsAreRightAndBoundsHold) {
  PathRunner runner;
  Random random(21);
  int none = 0;
  int used[3] = {0, 0, 0};
  for (int k = 0; k < scaled(2500); ++k) {
    const VoxelWorld world = k % 4 == 0 ? walled_world(random) : random_world(random);
    Voxel start{};
    Voxel goal{};
    if (!random_ends(world.grid, random, start, goal)) continue;
    ReferenceSearch reference(world.grid);
    const double optimum = reference.cost(start, goal);
    const Status status = runner.run(world.grid, fast_query(world, start, goal));
    ++used[static_cast<int>(runner.search().search_used)];
    ASSERT_LE(runner.search().pieces, tern::kSearchBound);
    if (optimum < 0.0) {
      ASSERT_EQ(status, Status::kNoPath) << "case " << k;
      ASSERT_EQ(runner.search().search_used, SearchUsed::kNone);
      ++none;
      continue;
    }
    ASSERT_TRUE(status == Status::kOk || status == Status::kSegmentsFull) << "case " << k;
    const double cost = runner.path().grid_length;
    ASSERT_NEAR(tern_test::walked_cost(world.grid, reference, runner.path()), cost, 1e-9) << "case " << k;
    const double bound = runner.search().search_bound;
    ASSERT_GE(bound, 1.0);
    ASSERT_LE(cost, bound * optimum + 1e-9) << "case " << k;
    if (runner.search().search_used == SearchUsed::kOptimal) {
      ASSERT_NEAR(cost, optimum, 1e-9) << "case " << k;
    }
  }
  EXPECT_GT(none, scaled(2500) / 100);
  EXPECT_GT(used[static_cast<int>(SearchUsed::kGuided)], scaled(2500) / 20);
  EXPECT_GT(used[static_cast<int>(SearchUsed::kOptimal)], scaled(2500) / 20);
}

/// A way to and fro of straight moves alone, 12 along each row and 8 to the next, in walls that split no block. Where
/// the optimal search has come to the last row, which leads straight to the goal, it has proven the cost of all of it.
TEST(FastPath, ABoundOfOneIsTheOptimum) {
  PathRunner runner;
  int tight = 0;
  for (int rows = 4; rows < 40; ++rows) {
    VoxelWorld world({8 * rows - 7, 13, 1});
    for (int k = 0; k + 1 < rows; ++k) world.block({8 * k + 1, k % 2, 0}, {8 * k + 7, 11 + k % 2, 0});
    const Status status =
        runner.run(world.grid, fast_query(world, {0, 0, 0}, {8 * rows - 8, rows % 2 == 0 ? 0 : 12, 0}));
    ASSERT_TRUE(status == Status::kOk || status == Status::kSegmentsFull) << rows;
    EXPECT_EQ(runner.path().grid_length, 12.0 * rows + 8.0 * (rows - 1)) << rows;
    const bool guided = runner.search().search_used == SearchUsed::kGuided;
    tight += guided && runner.search().search_bound == 1.0 ? 1 : 0;
  }
  EXPECT_GT(tight, 0);
}

/// A way along two bands of 700 walls each, around each of them. No search finds one with less turns.
TEST(FastPath, AWayOfTooManyTurnsIsSearchedAgain) {
  static_assert(2 * 2 * 700 > tern::kMaxJumpPoints, "two turns a wall");
  VoxelWorld world({1401, 7, 1});
  world.block({0, 3, 0}, {1399, 3, 0});
  for (int k = 0; k < 700; ++k) {
    for (const int band : {0, 4}) world.block({2 * k + 1, band + k % 2, 0}, {2 * k + 1, band + 1 + k % 2, 0});
  }
  PathRunner runner;
  tern_test::PathQuery query = fast_query(world, {0, 0, 0}, {0, 6, 0});
  ASSERT_EQ(runner.run(world.grid, query), Status::kJumpPointsFull);
  const std::uint32_t fast = runner.search().pieces;
  query.search = tern::SearchMode::kOptimal;
  ASSERT_EQ(runner.run(world.grid, query), Status::kJumpPointsFull);
  EXPECT_GT(fast, runner.search().pieces + 4000) << "the guided search goes from voxel to voxel";
}

TEST(FastPath, NeitherSlicesNorMemoryChangeThePath) {
  PathRunner whole;
  PathRunner other;
  Random random(22);
  for (int k = 0; k < scaled(40); ++k) {
    const VoxelWorld world = walled_world(random);
    Voxel start{};
    Voxel goal{};
    if (!random_ends(world.grid, random, start, goal)) continue;
    const tern_test::PathQuery query = fast_query(world, start, goal);
    const Status status = whole.run(world.grid, query);
    for (const std::uint32_t slice : {1u, 7u, 1000u}) {
      other.fill(static_cast<unsigned char>(slice));
      ASSERT_EQ(other.run(world.grid, query, slice), status);
      ASSERT_EQ(other.search().pieces, whole.search().pieces);
      ASSERT_EQ(other.search().search_used, whole.search().search_used);
      if (status == Status::kOk) tern_test::expect_same_raw(whole.path(), other.path());
    }
  }
}

}  // namespace
