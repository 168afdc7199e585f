// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "search/dominance.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "support/path_world.hpp"

namespace {

using tern::Cost;
using tern::dominated_else_record;
using tern::kStraightCost;
using tern::Voxel;
using tern_test::VoxelWorld;

std::unique_ptr<tern::DominanceMap> witnesses(const VoxelWorld& world) {
  std::unique_ptr<tern::DominanceMap> map(new tern::DominanceMap);
  std::memset(static_cast<void*>(map.get()), 0xA5, sizeof *map);
  tern::dominance_reset(*map, world.grid);
  return map;
}

TEST(PathWitness, ADearerWayIsADetourAndAnEqualOneIsNot) {
  const VoxelWorld world({8, 8, 8});
  const auto map = witnesses(world);
  EXPECT_FALSE(dominated_else_record(*map, world.grid, {4, 4, 4}, 10 * kStraightCost)) << "nothing is known yet";
  // Three steps along x prove a way of cost 13.
  EXPECT_FALSE(dominated_else_record(*map, world.grid, {7, 4, 4}, 13 * kStraightCost));
  EXPECT_TRUE(dominated_else_record(*map, world.grid, {7, 4, 4}, 13 * kStraightCost + 64));
  EXPECT_FALSE(dominated_else_record(*map, world.grid, {5, 5, 5}, 10 * kStraightCost + tern::kSpaceDiagonalCost));
  EXPECT_TRUE(dominated_else_record(*map, world.grid, {5, 5, 5}, 12 * kStraightCost));
}

TEST(PathWitness, NothingIsProvenThroughAnObstacleOrIntoAnotherBlock) {
  VoxelWorld world({8, 8, 8});
  world.block({1, 0, 0}, {1, 3, 3});
  const auto map = witnesses(world);
  EXPECT_FALSE(dominated_else_record(*map, world.grid, {0, 0, 0}, 0));
  EXPECT_FALSE(dominated_else_record(*map, world.grid, {2, 0, 0}, 1000 * kStraightCost)) << "behind the wall";
  EXPECT_TRUE(dominated_else_record(*map, world.grid, {0, 3, 0}, 1000 * kStraightCost)) << "before it";
  EXPECT_FALSE(dominated_else_record(*map, world.grid, {4, 0, 0}, 1000 * kStraightCost)) << "a block of its own";
}

TEST(PathWitness, TheCheapestVoxelOfABlockIsItsWitness) {
  const VoxelWorld world({4, 4, 4});
  const auto map = witnesses(world);
  EXPECT_FALSE(dominated_else_record(*map, world.grid, {0, 0, 0}, 10 * kStraightCost));
  EXPECT_FALSE(dominated_else_record(*map, world.grid, {3, 0, 0}, 5 * kStraightCost));
  EXPECT_TRUE(dominated_else_record(*map, world.grid, {0, 0, 0}, 9 * kStraightCost)) << "8 from the other side";
}

}  // namespace
