// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Jump point search against a plain A*: equal cost, valid paths, and the same path whatever the memory held and
// however the work was cut.
#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "support/path_world.hpp"
#include "support/reference_search.hpp"
#include "support/walked_path.hpp"

namespace {

using tern::Status;
using tern::Vec3;
using tern::Voxel;
using tern_test::PathQuery;
using tern_test::PathRunner;
using tern_test::Random;
using tern_test::random_ends;
using tern_test::random_world;
using tern_test::ReferenceSearch;
using tern_test::scaled;
using tern_test::VoxelWorld;
using tern_test::walked_cost;

void expect_same_path(const tern::Path& a, const tern::Path& b) {
  tern_test::expect_same_raw(a, b);
  ASSERT_EQ(a.count, b.count);
  EXPECT_EQ(std::memcmp(a.points, b.points, sizeof(Vec3) * static_cast<std::size_t>(a.count)), 0);
}

TEST(PathSearch, CostEqualsPlainAStarOnRandomGrids) {
  PathRunner runner;
  Random random(1);
  int solved = 0;
  int unsolvable = 0;
  for (int k = 0; k < scaled(24000); ++k) {
    const VoxelWorld world = random_world(random);
    Voxel start{};
    Voxel goal{};
    if (!random_ends(world.grid, random, start, goal)) continue;
    ReferenceSearch reference(world.grid);
    const double optimum = reference.cost(start, goal);
    const Status status = runner.run(world.grid, start, goal);
    if (optimum < 0.0) {
      ASSERT_EQ(status, Status::kNoPath) << "case " << k;
      ++unsolvable;
      continue;
    }
    // A maze may need more segments than a trajectory has; its jump-point path is there all the same.
    ASSERT_TRUE(status == Status::kOk || status == Status::kSegmentsFull) << "case " << k;
    ASSERT_NEAR(runner.path().grid_length, optimum, 1e-9) << "case " << k;
    ASSERT_NEAR(walked_cost(world.grid, reference, runner.path()), optimum, 1e-9) << "case " << k;
    ASSERT_NEAR(runner.path().raw_length, optimum, 1e-9) << "case " << k;
    ++solved;
  }
  EXPECT_GT(solved, scaled(24000) / 2);
  EXPECT_GT(unsolvable, scaled(24000) / 100);
}

/// Small maps seldom outlast the steps that a search begins with: here it jumps from the start, and after ten of them.
TEST(PathSearch, JumpsCostWhatPlainAStarDoes) {
  const std::unique_ptr<tern::Search> search(new tern::Search);
  std::memset(static_cast<void*>(search.get()), 0xA5, sizeof(tern::Search));
  Random random(5);
  int jumped = 0;
  for (int k = 0; k < scaled(12000); ++k) {
    const VoxelWorld world = random_world(random);
    Voxel start{};
    Voxel goal{};
    if (!random_ends(world.grid, random, start, goal)) continue;
    const double optimum = ReferenceSearch(world.grid).cost(start, goal);
    tern::search_begin(*search, world.grid, start, goal, k % 2 == 0 ? 0 : 10);
    Status status = Status::kRunning;
    tern::Work work;
    while (status == Status::kRunning) status = tern::search_expand(*search, world.grid, work);
    ASSERT_EQ(status, optimum < 0.0 ? Status::kNoPath : Status::kOk) << "case " << k;
    ASSERT_LE(search->units, 2 * search->store.count) << "case " << k << ": docs/search.md says 1.2";
    if (optimum < 0.0) continue;
    const double cost = static_cast<double>(search->store.nodes[store_find_or_add(search->store, search->goal)].g);
    ASSERT_NEAR(cost / static_cast<double>(tern::kStraightCost), optimum, 1e-7) << "case " << k;
    jumped += search->jumps ? 1 : 0;
  }
  EXPECT_GT(jumped, scaled(12000) / 2);
}

/// The longer a search lasts the farther its sweeps go, up to a bound: here it lasts that long.
TEST(PathSearch, ALongSearchCostsWhatPlainAStarDoes) {
  const std::unique_ptr<tern::Search> search(new tern::Search);
  Random random(6);
  VoxelWorld world({500, 500, 1});
  for (int k = 0; k < 100000; ++k) world.grid.mark_voxel(random_voxel(random, world.grid.spec().dims));
  const Voxel start{0, 0, 0};
  const Voxel goal{499, 499, 0};
  for (const Voxel& end : {start, goal}) world.grid.clear_voxel(end);
  world.grid.inflate();
  tern::search_begin(*search, world.grid, start, goal);
  Status status = Status::kRunning;
  tern::Work work;
  while (status == Status::kRunning) status = tern::search_expand(*search, world.grid, work);
  ASSERT_EQ(status, Status::kOk);
  EXPECT_GT(search->expanded, 17u * 1024u);
  const double cost = static_cast<double>(search->store.nodes[store_find_or_add(search->store, search->goal)].g);
  EXPECT_NEAR(cost / static_cast<double>(tern::kStraightCost), ReferenceSearch(world.grid).cost(start, goal), 1e-6);
}

TEST(PathSearch, SlicesDoNotChangeThePath) {
  PathRunner whole;
  PathRunner sliced;
  Random random(2);
  for (int k = 0; k < scaled(400); ++k) {
    const VoxelWorld world = random_world(random);
    Voxel start{};
    Voxel goal{};
    if (!random_ends(world.grid, random, start, goal)) continue;
    const PathQuery query{world.grid.center(start), world.grid.center(goal)};
    const Status status = whole.run(world.grid, query);
    for (const std::uint32_t slice : {1u, 2u, 7u}) {
      ASSERT_EQ(sliced.run(world.grid, query, slice), status);
      ASSERT_EQ(sliced.search().pieces, whole.search().pieces);
      ASSERT_EQ(sliced.shortcut().pieces, whole.shortcut().pieces);
      if (status == Status::kOk) expect_same_path(whole.path(), sliced.path());
    }
  }
}

TEST(PathSearch, MemoryMayBeginWithAnyBits) {
  PathRunner reused;
  PathRunner filled;
  Random random(3);
  for (int k = 0; k < scaled(60); ++k) {
    const VoxelWorld world = random_world(random);
    Voxel start{};
    Voxel goal{};
    if (!random_ends(world.grid, random, start, goal)) continue;
    const Status status = reused.run(world.grid, start, goal);
    for (const unsigned char byte : {0x00, 0x01, 0xA5, 0xFF}) {
      filled.fill(byte);
      ASSERT_EQ(filled.run(world.grid, start, goal), status);
      ASSERT_EQ(filled.search().pieces, reused.search().pieces);
      if (status == Status::kOk) expect_same_path(reused.path(), filled.path());
    }
  }
}

TEST(PathSearch, WorkStaysWithinItsBounds) {
  PathRunner runner;
  Random random(4);
  for (int k = 0; k < scaled(1000); ++k) {
    const VoxelWorld world = random_world(random);
    Voxel start{};
    Voxel goal{};
    if (!random_ends(world.grid, random, start, goal)) continue;
    runner.run(world.grid, start, goal);
    const tern::SearchStage& stage = runner.search();
    // Each search that found no way is followed by another from elsewhere, where an end can join elsewhere.
    const unsigned searches = stage.failed + 1;
    EXPECT_LE(stage.pieces, searches * (27u * static_cast<unsigned>(stage.nodes_high) + 2u * tern::kMaxJoins));
    EXPECT_LE(stage.pieces, tern::kSearchBound);
    EXPECT_LE(stage.open_high, stage.nodes_high);
    EXPECT_LE(runner.shortcut().pieces, tern::kShortcutBound);
  }
}

}  // namespace
