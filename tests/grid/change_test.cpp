// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Incremental inflation: after any sequence of marks and clears, both layers equal, bit for bit, those of a new grid
// that was told the same obstacles and inflated once.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/grid_storage.hpp"
#include "support/random.hpp"
#include "tern/grid.hpp"

namespace {

using tern::Box;
using tern::Grid;
using tern::GridSpec;
using tern::Status;
using tern::Vec3;
using tern::Voxel;
using tern_test::OwnedGrid;
using tern_test::Random;
using tern_test::scaled;

/// Both layers of a grid, row after row.
std::vector<std::uint64_t> layers(const Grid& grid) {
  const std::size_t count = static_cast<std::size_t>(grid.row_words()) * grid.spec().dims.y * grid.spec().dims.z;
  std::vector<std::uint64_t> out(grid.obstacle_row(0, 0), grid.obstacle_row(0, 0) + count);
  out.insert(out.end(), grid.blocked_row(0, 0), grid.blocked_row(0, 0) + count);
  return out;
}

/// A new grid with the same obstacles, inflated once.
std::vector<std::uint64_t> rebuilt(const Grid& grid) {
  OwnedGrid fresh(grid.spec());
  tern_test::copy_obstacles(grid, fresh.grid);
  return layers(fresh.grid);
}

/// The boundary is the whole grid or a random part of it, often cutting voxels.
GridSpec random_spec(Random& random, const Voxel& dims, double radius) {
  GridSpec spec = tern_test::whole_grid(dims, 0.1, radius, {random.real(-3.0, 3.0), 0.0, -1.0});
  if (random.chance(0.5)) return spec;
  const auto shrink = [&](double& lower, double& upper) {
    const double size = upper - lower;
    upper = lower + size * random.real(0.5, 1.0);
    lower += size * random.real(0.0, 0.5);
  };
  shrink(spec.boundary.lower.x, spec.boundary.upper.x);
  shrink(spec.boundary.lower.y, spec.boundary.upper.y);
  shrink(spec.boundary.lower.z, spec.boundary.upper.z);
  return spec;
}

Vec3 random_point(Random& random, const GridSpec& spec) {
  const auto on = [&](double origin, int count) { return origin + spec.cell * random.real(-2.0, count + 2.0); };
  return {on(spec.origin.x, spec.dims.x), on(spec.origin.y, spec.dims.y), on(spec.origin.z, spec.dims.z)};
}

/// A box around a random point: from one voxel to a quarter of the grid on each axis.
Box random_box(Random& random, const GridSpec& spec) {
  const Vec3 a = random_point(random, spec);
  const auto size = [&](int count) { return spec.cell * random.real(0.0, random.chance(0.5) ? 2.0 : 0.25 * count); };
  return {a, {a.x + size(spec.dims.x), a.y + size(spec.dims.y), a.z + size(spec.dims.z)}};
}

/// One random change, by any of the calls that change a grid.
void change(Random& random, Grid& grid) {
  const GridSpec& spec = grid.spec();
  const Voxel voxel{random.integer(0, spec.dims.x - 1), random.integer(0, spec.dims.y - 1),
                    random.integer(0, spec.dims.z - 1)};
  // The voxels beside a word's end, where a change reaches into the next word.
  const Voxel edge{std::min((voxel.x | 63) + random.integer(-3, 3), spec.dims.x - 1), voxel.y, voxel.z};
  switch (random.integer(0, 5)) {
    case 0:
      ASSERT_EQ(grid.mark_box(random_box(random, spec)), Status::kOk);
      break;
    case 1:
      ASSERT_EQ(grid.clear_box(random_box(random, spec)), Status::kOk);
      break;
    case 2:
      ASSERT_EQ(grid.mark_voxel(random.chance(0.5) ? voxel : edge), Status::kOk);
      break;
    case 3:
      ASSERT_EQ(grid.clear_voxel(random.chance(0.5) ? voxel : edge), Status::kOk);
      break;
    case 4: {
      std::vector<Vec3> points(static_cast<std::size_t>(random.integer(1, 40)));
      for (Vec3& point : points) point = random_point(random, spec);
      ASSERT_EQ(grid.mark_points(points.data(), points.size()), Status::kOk);
      break;
    }
    default:
      ASSERT_EQ(grid.clear_box({spec.boundary.lower, spec.boundary.upper}), Status::kOk);
  }
}

void expect_equal_to_rebuilding(Random& random, const GridSpec& spec, int rounds) {
  OwnedGrid owned(spec);
  ASSERT_EQ(owned.status, Status::kOk);
  for (int round = 0; round < rounds; ++round) {
    for (int k = random.integer(0, 4); k > 0; --k) ASSERT_NO_FATAL_FAILURE(change(random, owned.grid));
    owned.grid.inflate();
    ASSERT_TRUE(owned.grid.inflated());
    ASSERT_EQ(layers(owned.grid), rebuilt(owned.grid))
        << spec.dims.x << 'x' << spec.dims.y << 'x' << spec.dims.z << " radius " << spec.radius << " round " << round;
  }
}

TEST(GridChange, EqualsRebuildingOnEveryShape) {
  Random random(201);
  constexpr Voxel kShapes[] = {{1, 1, 1},    {64, 1, 1},  {65, 1, 1},  {1, 70, 1},    {1, 1, 70},   {63, 9, 9},
                               {64, 9, 9},   {65, 9, 9},  {127, 7, 7}, {128, 7, 7},   {129, 7, 7},  {20, 64, 5},
                               {20, 65, 5},  {3, 130, 3}, {200, 3, 3}, {330, 4, 4},   {20, 20, 66}, {700, 5, 3},
                               {190, 70, 9}, {5, 5, 5},   {70, 1, 70}, {400, 130, 2}, {256, 66, 3}};
  for (int k = 0; k < scaled(400); ++k) {
    const Voxel dims = kShapes[k % static_cast<int>(std::size(kShapes))];
    const double radius = random.chance(0.15) ? 0.0 : random.real(0.0, random.chance(0.2) ? 1.2 : 0.5);
    ASSERT_NO_FATAL_FAILURE(expect_equal_to_rebuilding(random, random_spec(random, dims, radius), 8));
  }
}

TEST(GridChange, EqualsRebuildingWithBallsBeyondAWordAndABlockOfRows) {
  Random random(202);
  constexpr Voxel kShapes[] = {{300, 20, 6}, {10, 200, 6}, {200, 150, 3}, {10, 10, 150}};
  for (int k = 0; k < scaled(40); ++k) {
    const GridSpec spec = random_spec(random, kShapes[k % 4], random.real(1.0, 9.0));
    ASSERT_NO_FATAL_FAILURE(expect_equal_to_rebuilding(random, spec, 5));
  }
}

TEST(GridChange, BindingAgainForgetsTheFormerRadius) {
  Random random(203);
  for (int k = 0; k < scaled(60); ++k) {
    const Voxel dims{random.integer(1, 140), random.integer(1, 70), random.integer(1, 9)};
    OwnedGrid owned(random_spec(random, dims, 0.0));
    for (int radius = 3; radius >= 0; --radius) {
      const GridSpec spec = random_spec(random, dims, 0.1 * radius);
      ASSERT_EQ(owned.grid.bind(spec, owned.words.data(), owned.words.size()), Status::kOk);
      ASSERT_NO_FATAL_FAILURE(change(random, owned.grid));
      owned.grid.inflate();
      ASSERT_EQ(layers(owned.grid), rebuilt(owned.grid));
    }
  }
}

TEST(GridChange, CopiesShareWhatChanged) {
  OwnedGrid owned(tern_test::whole_grid({70, 20, 20}, 0.1, 0.2));
  Grid copy = owned.grid;
  ASSERT_EQ(owned.grid.mark_voxel({64, 10, 10}), Status::kOk);
  copy.inflate();
  EXPECT_TRUE(owned.grid.inflated());
  EXPECT_EQ(layers(copy), rebuilt(owned.grid));
  EXPECT_EQ(layers(owned.grid), rebuilt(owned.grid));
}

TEST(GridChange, OnlyWordsNearAChangeAreMadeAgain) {
  OwnedGrid owned(tern_test::whole_grid({256, 40, 40}, 0.1, 0.2));
  owned.grid.inflate();
  // A scribble in the blocked layer stays where nothing changed nearby, and goes where something did.
  auto* far = const_cast<std::uint64_t*>(owned.grid.blocked_row(30, 20));
  auto* near = const_cast<std::uint64_t*>(owned.grid.blocked_row(11, 20));
  far[0] = far[3] = near[3] = near[0] = 0x5A5Au;
  owned.grid.inflate();
  EXPECT_EQ(near[0], 0x5A5Au);
  ASSERT_EQ(owned.grid.mark_voxel({10, 10, 20}), Status::kOk);
  owned.grid.inflate();
  EXPECT_NE(near[0], 0x5A5Au);
  EXPECT_EQ(near[3], 0x5A5Au);
  EXPECT_EQ(far[0], 0x5A5Au);
  EXPECT_EQ(far[3], 0x5A5Au);
}

TEST(GridChange, MarkingWhatIsMarkedMakesNothingAgain) {
  OwnedGrid owned(tern_test::whole_grid({100, 20, 20}, 0.1, 0.2));
  ASSERT_EQ(owned.grid.mark_voxel({10, 10, 10}), Status::kOk);
  owned.grid.inflate();
  auto* row = const_cast<std::uint64_t*>(owned.grid.blocked_row(10, 10));
  row[0] = 0x5A5Au;
  ASSERT_EQ(owned.grid.mark_voxel({10, 10, 10}), Status::kOk);
  EXPECT_FALSE(owned.grid.inflated());
  owned.grid.inflate();
  EXPECT_TRUE(owned.grid.inflated());
  EXPECT_EQ(row[0], 0x5A5Au);
}

}  // namespace
