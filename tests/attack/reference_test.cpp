// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The reference's blocked layer, its components and its solids against what a hand can compute.
#include "attack/reference.hpp"

#include <gtest/gtest.h>

#include "attack/clearance.hpp"
#include "attack/solid.hpp"

namespace tern_attack {
namespace {

void make_hand_world(World& world, const tern::Voxel& dims, double cell, double radius) {
  world.spec.origin = {0.0, 0.0, 0.0};
  world.spec.cell = cell;
  world.spec.dims = dims;
  world.spec.boundary = {{0.0, 0.0, 0.0}, {dims.x * cell, dims.y * cell, dims.z * cell}};
  world.spec.radius = radius;
  world.solid.assign(static_cast<std::size_t>(world.count()), 0);
}

Space at(const World& world, const std::vector<Space>& layer, int x, int y, int z) {
  return layer[static_cast<std::size_t>(world.index(x, y, z))];
}

TEST(BlockedLayer, TiesAreFree) {
  World world;
  make_hand_world(world, {9, 9, 9}, 0.1, std::sqrt(2.0) * 0.1);
  world.set(4, 4, 4, true);
  const std::vector<Space> layer = blocked_layer(world);
  EXPECT_EQ(at(world, layer, 4, 4, 4), Space::kBlocked);
  EXPECT_EQ(at(world, layer, 5, 5, 5), Space::kBlocked);  // touches
  EXPECT_EQ(at(world, layer, 6, 4, 4), Space::kBlocked);  // one cell between
  EXPECT_EQ(at(world, layer, 6, 6, 4), Space::kFree);     // sqrt 2 cells between: a tie
  EXPECT_EQ(at(world, layer, 7, 4, 4), Space::kFree);
}

TEST(BlockedLayer, ARadiusOfANanometreIsNone) {
  World world;
  make_hand_world(world, {3, 3, 3}, 0.1, 1e-9);
  world.set(1, 1, 1, true);
  EXPECT_EQ(at(world, blocked_layer(world), 0, 1, 1), Space::kFree);
  world.spec.radius = 2e-9;
  EXPECT_EQ(at(world, blocked_layer(world), 0, 1, 1), Space::kBlocked);
}

TEST(BlockedLayer, TheBoundaryBlocksWhatItCuts) {
  World world;
  make_hand_world(world, {4, 4, 4}, 0.5, 0.0);
  world.spec.boundary.lower.x = 0.5;
  world.spec.boundary.upper.y = 1.9;
  const std::vector<Space> layer = blocked_layer(world);
  EXPECT_EQ(at(world, layer, 0, 1, 1), Space::kBlocked);
  EXPECT_EQ(at(world, layer, 1, 1, 1), Space::kFree);
  EXPECT_EQ(at(world, layer, 1, 3, 1), Space::kBlocked);
}

/// Where no whole voxel fits, those that it meets count; of a plane, those on both sides.
TEST(BlockedLayer, AThinBoundaryOpensTheLayersThatItMeets) {
  const struct {
    double lower, upper;
    int first, last;
  } cases[] = {{0.5, 0.5, 0, 1},   {0.75, 0.75, 1, 1}, {0.5, 0.9, 1, 1},
               {0.75, 1.25, 1, 2}, {0.0, 0.0, 0, 0},   {2.0, 2.0, 3, 3}};
  for (const auto& thin : cases) {
    World world;
    make_hand_world(world, {4, 4, 4}, 0.5, 0.0);
    world.spec.boundary.lower.z = thin.lower;
    world.spec.boundary.upper.z = thin.upper;
    const std::vector<Space> layer = blocked_layer(world);
    for (int z = 0; z < 4; ++z) {
      const bool open = z >= thin.first && z <= thin.last;
      EXPECT_EQ(at(world, layer, 1, 1, z), open ? Space::kFree : Space::kBlocked) << thin.lower << ' ' << z;
    }
  }
}

/// The definition, pair by pair, on worlds of every family.
TEST(BlockedLayer, EqualsTheDefinition) {
  for (std::uint64_t number = 0; number < 40; ++number) {
    Rng rng = rng_of(7, number);
    World world;
    make_world(rng, static_cast<Family>(number % 7), world);
    if (world.count() > 4000) continue;
    world.spec.boundary = {world.spec.origin, world.spec.origin};
    for (int a = 0; a < 3; ++a) axis(world.spec.boundary.upper, a) += axis(world.spec.dims, a) * world.spec.cell;
    const std::vector<Space> layer = blocked_layer(world);
    const Real q = std::pow(world.radius() / static_cast<Real>(world.spec.cell), 2);
    for (int i = 0; i < world.count(); ++i) {
      const tern::Voxel v = world.voxel(i);
      Real least = 1e9L;
      for (int j = 0; j < world.count(); ++j) {
        if (world.solid[static_cast<std::size_t>(j)] == 0) continue;
        const tern::Voxel w = world.voxel(j);
        Real gaps = 0;
        for (int a = 0; a < 3; ++a) gaps += std::pow(std::max(0, std::abs(axis(v, a) - axis(w, a)) - 1), 2);
        least = std::min(least, gaps);
      }
      const bool solid = world.solid[static_cast<std::size_t>(i)] != 0;
      const bool blocked = q > 0 ? least < q * (1 - 1e-9L) : solid;
      ASSERT_EQ(layer[static_cast<std::size_t>(i)], blocked ? Space::kBlocked : Space::kFree) << number << " " << i;
    }
  }
}

TEST(Components, DoNotPassBetweenTouchingCorners) {
  World world;
  make_hand_world(world, {2, 2, 1}, 1.0, 0.0);
  const std::vector<int> number = components(world, {1, 0, 0, 1});
  EXPECT_EQ(number[1], -1);
  EXPECT_NE(number[0], number[3]);
  const std::vector<int> joined = components(world, {1, 1, 0, 1});
  EXPECT_EQ(joined[0], joined[3]);
}

TEST(Reachable, AServedPointReachesEverySideThatItSees) {
  World world;
  // Radius of a cell between walls at x = 0 and x = 5, the point in the middle of two blocked voxels of a narrower
  // part.
  make_hand_world(world, {12, 5, 1}, 1.0, 1.0);
  for (int y = 0; y < 5; y += 4) {
    for (int x = 4; x < 8; ++x) world.set(x, y == 0 ? 0 : 3, 0, true);
  }
  std::vector<std::uint8_t> free;
  for (const Space s : blocked_layer(world)) free.push_back(s == Space::kFree ? 1 : 0);
  const std::vector<int> number = components(world, free);
  // The gap is exactly twice the radius wide: its middle keeps the radius, no voxel of it is free.
  EXPECT_EQ(number[static_cast<std::size_t>(world.index(4, 2, 0))], -1);
  const std::vector<int> side = reachable(world, number, {{3.5L, 2.0L, 0.5L}});
  ASSERT_EQ(side.size(), 1u);
  EXPECT_EQ(side[0], number[static_cast<std::size_t>(world.index(2, 2, 0))]);
}

TEST(Homes, APlaneBelongsToTheVoxelAboveAndTheUpperFaceToTheLast) {
  World world;
  make_hand_world(world, {4, 4, 4}, 0.1, 0.0);
  const std::vector<tern::Voxel> own = homes(world, {{0.2L, 0.4L, 0.05L}});
  ASSERT_GE(own.size(), 1u);
  for (const tern::Voxel& v : own) {
    EXPECT_EQ(v.y, 3);
    EXPECT_EQ(v.z, 0);
    EXPECT_TRUE(v.x == 1 || v.x == 2);
  }
}

TEST(Clearance, IsExactToTheLastNanometre) {
  World world;
  make_hand_world(world, {8, 8, 8}, 1.0, 1.0);
  world.set(3, 3, 3, true);
  // Past the corner (4, 4, 4) at a distance of 1, square to the diagonal.
  const Real d = 1 / std::sqrt(3.0L);
  const Point middle{{4 + d, 4 + d, 4 + d}};
  const Point along{{1, -1, 0}};
  const Curve past = line(middle - 2 * along, middle + 2 * along);
  EXPECT_EQ(clearance(world, past, 1 - 1e-9L).proof, Proof::kProven);
  EXPECT_EQ(clearance(world, past, 1 + 1e-9L).proof, Proof::kBroken);
}

TEST(SolidDistance, OfABoxAndOfANeedle) {
  World world;
  make_hand_world(world, {10, 10, 10}, 1.0, 0.5);
  tern::Halfspace faces[tern::kBoxPlanes];
  tern::box_planes({{4.0, 4.0, 4.0}, {6.0, 6.0, 6.0}}, faces);
  const Solid box(world, {faces, tern::kBoxPlanes, tern::FenceKind::kKeepOut});
  EXPECT_NEAR(static_cast<double>(box.distance({{7.0L, 5.0L, 5.0L}})), 1.0, 1e-15);
  EXPECT_NEAR(static_cast<double>(box.distance({{7.0L, 7.0L, 7.0L}})), std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(static_cast<double>(box.distance({{5.5L, 5.0L, 5.0L}})), -0.5, 1e-15);
  // A wedge whose faces meet at 2e-6 along y, its edge at (5, y, 5).
  const tern::Halfspace wedge[] = {{{1e-6, 0.0, 1.0}, 5.0 + 5e-6}, {{1e-6, 0.0, -1.0}, -5.0 + 5e-6}};
  const Solid needle(world, {wedge, 2, tern::FenceKind::kKeepOut});
  EXPECT_NEAR(static_cast<double>(needle.distance({{7.0L, 5.0L, 5.0L}})), 2.0, 1e-8);
}

}  // namespace
}  // namespace tern_attack
