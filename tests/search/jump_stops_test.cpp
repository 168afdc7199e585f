// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Stops of scans and walks against the pruning rule itself, voxel by voxel, on random maps of many shapes: rows that
// end within and at the end of a word, maps one voxel thin, tiles made before, during and after the walks.
#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "search/neighbourhood.hpp"
#include "search/prune.hpp"
#include "search/straight_jump.hpp"
#include "support/path_world.hpp"

namespace {

using tern::Voxel;
using tern_test::Random;
using tern_test::random_free;
using tern_test::random_world;
using tern_test::scaled;
using tern_test::VoxelWorld;

/// By definition: step by step, asking the pruning rule at each voxel.
int slow_scan(const tern::Grid& grid, const Voxel& goal, Voxel at, int move, int along) {
  for (;;) {
    at = at + tern::offset(move);
    if (!grid.free(at)) return tern::straight_jump::kNowhere;
    const tern::CellMask free = tern::free_cells(grid, at);
    const bool forced = tern::forced_moves(move, free, tern::legal_moves(free)) != 0;
    if (forced || tern::same(at, goal)) return tern::axis(at, along);
  }
}

struct Scans {
  template <int kAxis, bool kUp>
  void expect_equal(const tern::Grid& grid, const Voxel& goal, const Voxel& from) {
    int step[3] = {0, 0, 0};
    step[kAxis] = kUp ? 1 : -1;
    const int move = tern::direction(step[0], step[1], step[2]);
    const int expected = slow_scan(grid, goal, from, move, kAxis);
    const int found = tern::jump_straight<kAxis, kUp>(stops[kAxis], grid, goal, from);
    ASSERT_EQ(found, expected) << from.x << ' ' << from.y << ' ' << from.z << " along " << kAxis << (kUp ? '+' : '-');
    ++(expected == tern::straight_jump::kNowhere ? nothing : something);
  }
  void expect_all_equal(const tern::Grid& grid, const Voxel& goal, const Voxel& from) {
    expect_equal<0, true>(grid, goal, from);
    expect_equal<0, false>(grid, goal, from);
    expect_equal<1, true>(grid, goal, from);
    expect_equal<1, false>(grid, goal, from);
    expect_equal<2, true>(grid, goal, from);
    expect_equal<2, false>(grid, goal, from);
  }

  /// Prepares layers whose memory starts as garbage.
  void begin(const tern::Grid& grid) {
    std::memset(static_cast<void*>(stops.get()), 0xA5, 3 * sizeof stops[0]);
    for (int a = 0; a < 3; ++a) tern::jump_stops_reset(stops[a], grid, a);
  }

  std::unique_ptr<tern::JumpStopLayer[]> stops{new tern::JumpStopLayer[3]};
  int something = 0;
  int nothing = 0;
};

TEST(PathStops, ScansStopWhereTheRuleSays) {
  Scans scans;
  Random random(71);
  for (int k = 0; k < scaled(600); ++k) {
    const VoxelWorld world = random_world(random);
    Voxel goal{};
    if (!random_free(world.grid, random, goal)) continue;
    scans.begin(world.grid);
    // So many that tiles are walked at first and made on the way.
    for (int m = 0; m < 60; ++m) {
      Voxel from{};
      if (!random_free(world.grid, random, from)) break;
      ASSERT_NO_FATAL_FAILURE(scans.expect_all_equal(world.grid, goal, from)) << "case " << k;
    }
  }
  EXPECT_GT(scans.something, scaled(600));
  EXPECT_GT(scans.nothing, scaled(600));
}

TEST(PathStops, LinesAreRightAcrossWordsAndFaces) {
  Scans scans;
  Random random(72);
  static const Voxel kShapes[] = {{128, 3, 3}, {3, 128, 3}, {3, 3, 128}, {65, 65, 2}, {2, 64, 129}, {129, 1, 64}};
  int tiles_made = 0;
  for (const Voxel& dims : kShapes) {
    VoxelWorld world(dims);
    for (int m = 0; m < dims.x * dims.y * dims.z / 12; ++m) {
      world.grid.mark_voxel(random_voxel(random, dims));
    }
    world.grid.inflate();
    scans.begin(world.grid);
    for (int m = 0; m < scaled(6000); ++m) {
      Voxel from{};
      if (!random_free(world.grid, random, from)) break;
      ASSERT_NO_FATAL_FAILURE(scans.expect_all_equal(world.grid, {0, 0, 0}, from)) << dims.x << 'x' << dims.y;
    }
    tiles_made += __builtin_popcountll(scans.stops[1].ready[0]) + __builtin_popcountll(scans.stops[2].ready[0]);
  }
  EXPECT_GT(tiles_made, 0) << "the walks never turned into tiles";
}

/// A flat map has more lines across it than a layer holds: there scans go step by step.
TEST(PathStops, LayersThatDoNotFitAreNotUsed) {
  static_assert(1100 * 1100 > tern::kJumpStopWords, "the map must not fit");
  Scans scans;
  VoxelWorld world({1, 1100, 1100});
  for (const Voxel& blocked : {Voxel{0, 41, 60}, Voxel{0, 1099, 41}, Voxel{0, 1050, 1089}}) world.block(blocked);
  scans.begin(world.grid);
  EXPECT_EQ(scans.stops[0].words, 0);
  for (const Voxel& from : {Voxel{0, 40, 40}, Voxel{0, 1080, 40}, Voxel{0, 1090, 1090}, Voxel{0, 40, 1090}}) {
    ASSERT_NO_FATAL_FAILURE(scans.expect_all_equal(world.grid, {0, 0, 0}, from));
  }
  EXPECT_GT(scans.something, 0);
}

}  // namespace
