// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// F09 for the guided search: each of its capacities runs out in a build where that is cheap. None is the plan's
// business: the optimal search answers then.
#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "guide/voxel_search.hpp"
#include "support/path_world.hpp"
#include "support/reference_search.hpp"

namespace {

using tern::Status;
using tern::Voxel;
using tern_test::Random;
using tern_test::random_ends;
using tern_test::random_free;
using tern_test::VoxelWorld;

VoxelWorld strewn_world(Random& random) {
  VoxelWorld world({32, 32, 16});
  const int blocks = random.integer(0, 3000);
  for (int k = 0; k < blocks; ++k) {
    world.grid.mark_voxel({random.integer(0, 31), random.integer(0, 31), random.integer(0, 15)});
  }
  world.grid.inflate();
  return world;
}

TEST(TinyGuide, EveryCapacityRunsOut) {
  const std::unique_ptr<tern::GuidedSearch> search(new tern::GuidedSearch);
  std::memset(static_cast<void*>(search.get()), 0xA5, sizeof *search);
  Random random(71);
  int voxels = 0;
  int pages = 0;
  int open = 0;
  int blocks = 0;
  for (int k = 0; k < 6000; ++k) {
    const VoxelWorld world = strewn_world(random);
    Voxel start{};
    Voxel goal{};
    if (!random_ends(world.grid, random, start, goal)) continue;
    ASSERT_TRUE(guided_begin(*search, world.grid, start, goal));
    tern::Work work{0xFFFFFFFFu};
    const Status status = guided_advance(*search, world.grid, work);
    ASSERT_LE(0xFFFFFFFFu - work.left, tern::kGuidedBound);
    ASSERT_LE(search->store.count, tern::kGuidePages);
    ASSERT_LE(search->open.count, tern::kGuidedOpen);
    ASSERT_LE(search->guide.open.count, tern::kBlockOpen);
    const bool nodes_full = status == Status::kNodesFull;
    voxels += nodes_full && search->expanded > tern::kGuidedExpansions ? 1 : 0;
    pages += nodes_full && search->store.count == tern::kGuidePages ? 1 : 0;
    open += status == Status::kOpenFull && search->open.count == tern::kGuidedOpen ? 1 : 0;
    blocks += status == Status::kOpenFull && search->guide.open.count == tern::kBlockOpen ? 1 : 0;
  }
  EXPECT_GT(voxels, 0);
  EXPECT_GT(pages, 0);
  EXPECT_GT(open, 0);
  EXPECT_GT(blocks, 0);
}

TEST(TinyGuide, TheOptimalSearchAnswersThen) {
  tern_test::PathRunner runner;
  Random random(72);
  int fallen_back = 0;
  for (int k = 0; k < 600; ++k) {
    const VoxelWorld world = strewn_world(random);
    Voxel start{};
    if (!random_free(world.grid, random, start)) continue;
    const Voxel goal{(start.x + random.integer(0, 6)) % 32, (start.y + random.integer(0, 6)) % 32, start.z};
    if (!world.grid.free(goal)) continue;
    tern_test::PathQuery query{world.grid.center(start), world.grid.center(goal)};
    const Status optimal = runner.run(world.grid, query);
    query.search = tern::SearchMode::kFast;
    const Status fast = runner.run(world.grid, query);
    if (optimal == Status::kOk || optimal == Status::kNoPath) {
      ASSERT_TRUE(fast == optimal || fast == Status::kSegmentsFull) << "case " << k;
    }
    fallen_back += runner.search().search_used == tern::SearchUsed::kOptimal ? 1 : 0;
  }
  EXPECT_GT(fallen_back, 0);
}

}  // namespace
