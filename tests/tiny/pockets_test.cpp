// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Searches from one pocket after the other end once they have taken a bound of work together, which is small in the
// tiny profile.
#include <gtest/gtest.h>

#include <initializer_list>

#include "support/path_world.hpp"

namespace {

using tern::Status;
using tern::Vec3;
using tern::Voxel;
using tern_test::PathQuery;
using tern_test::Random;
using tern_test::VoxelWorld;

void dig(VoxelWorld& world, std::initializer_list<Voxel> voxels) {
  for (const Voxel& voxel : voxels) world.grid.clear_voxel(voxel);
}

/// A room of 18 x 18 x 2 voxels with some pillars.
void dig_room(VoxelWorld& world, Random& random, int x0, int y0) {
  constexpr int kSize = 18;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) dig(world, {{x0 + x, y0 + y, 3}, {x0 + x, y0 + y, 4}});
  }
  for (int k = 0; k < 3; ++k) {
    const int x = x0 + random.integer(2, kSize - 3);
    const int y = y0 + random.integer(2, kSize - 3);
    world.block({x, y, 3}, {x, y, 4});
  }
}

/// Six voxels that the start in a corner of the lattice sees, each with a way of its own into one of four rooms; and
/// eight that the goal sees, with none.
void dig_pockets(VoxelWorld& world) {
  dig(world, {{32, 32, 4}, {33, 32, 4}, {34, 32, 4}, {35, 32, 4}, {35, 33, 4}, {35, 34, 4}, {35, 35, 4}, {36, 35, 4}});
  dig(world, {{33, 33, 5}, {33, 33, 6}, {33, 33, 7}, {34, 33, 7}, {35, 33, 7}, {36, 33, 7}, {36, 34, 7}, {36, 35, 7}});
  dig(world, {{36, 36, 7}, {36, 36, 6}, {36, 36, 5}});
  dig(world, {{31, 31, 4}, {30, 31, 4}, {29, 31, 4}, {28, 31, 4}, {28, 30, 4}, {28, 29, 4}, {28, 28, 4}, {27, 28, 4}});
  dig(world, {{30, 30, 5}, {30, 30, 6}, {30, 30, 7}, {29, 30, 7}, {28, 30, 7}, {27, 30, 7}, {27, 29, 7}, {27, 28, 7}});
  dig(world, {{27, 27, 7}, {27, 27, 6}, {27, 27, 5}});
  dig(world, {{32, 31, 3}, {33, 31, 3}, {34, 31, 3}, {35, 31, 3}, {35, 30, 3}, {35, 29, 3}, {35, 28, 3}, {36, 28, 3}});
  dig(world, {{36, 27, 3}, {31, 32, 3}, {30, 32, 3}, {29, 32, 3}, {28, 32, 3}, {28, 33, 3}, {28, 34, 3}, {28, 35, 3}});
  dig(world, {{27, 35, 3}, {27, 36, 3}, {27, 28, 3}, {36, 35, 3}});
  dig(world, {{2, 2, 2}, {1, 1, 2}, {2, 1, 1}, {1, 2, 1}, {3, 3, 3}, {0, 0, 3}, {3, 0, 0}, {0, 3, 0}});
}

TEST(TinyPockets, NoSearchBeginsOnceABoundIsSpent) {
  Random random(5);
  tern_test::PathRunner runner;
  int spent = 0;
  for (int k = 0; k < 400 && spent == 0; ++k) {
    VoxelWorld world({64, 64, 8});
    world.block({0, 0, 0}, {63, 63, 7});
    for (const int x : {10, 36}) {
      for (const int y : {10, 36}) dig_room(world, random, x, y);
    }
    dig_pockets(world);
    world.grid.inflate();
    PathQuery query{{32.0, 32.0, 4.0}, {2.0, 2.0, 2.0}};
    query.start_moves = query.goal_moves = true;  // all that a line leads to, and not only what meets in the corner
    const Status status = runner.run(world.grid, query);
    if (status == Status::kNodesFull) continue;  // of a room
    ASSERT_EQ(status, Status::kNoPath);
    ++spent;
    EXPECT_GE(runner.search().pieces, tern::kExpansionBound);
    EXPECT_LE(runner.search().pieces, tern::kSearchBound);
    EXPECT_LT(runner.search().failed, 48u) << "six by eight";
    EXPECT_GT(runner.search().failed, tern::kExpansionBound / tern::kMaxNodes / 2);
  }
  EXPECT_EQ(spent, 1);
}

}  // namespace
