// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid/local_boxes.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <vector>

#include "support/at_once.hpp"
#include "support/corridor_reference.hpp"
#include "support/random.hpp"

namespace tern_test {
namespace {

using tern::Box;
using tern::LocalBox;
using tern::Voxel;
using tern::VoxelRange;

struct Extraction {
  std::unique_ptr<tern::ExtractScratch> scratch = std::make_unique<tern::ExtractScratch>();
  std::vector<LocalBox> boxes = std::vector<LocalBox>(tern::kMaxLocalBoxes);
  int count = 0;

  void run(const MarkedWorld& world, const VoxelRange& range) {
    std::memset(static_cast<void*>(scratch.get()), 0xA5, sizeof *scratch);
    count = tern_test::extract_local_boxes(world.grid, range, *scratch, boxes.data());
  }
};

VoxelRange whole(const MarkedWorld& world) {
  return {{0, 0, 0}, world.grid.spec().dims};
}

TEST(CorridorBoxes, AnEmptyRangeHasNone) {
  MarkedWorld world({70, 5, 5}, 0.5, 0.0);
  world.fill({0, 0, 0}, {70, 5, 5});
  Extraction extraction;
  extraction.run(world, {{3, 2, 2}, {3, 4, 4}});
  EXPECT_EQ(extraction.count, 0);
  extraction.run(world, {{3, 2, 2}, {9, 2, 4}});
  EXPECT_EQ(extraction.count, 0);
  extraction.run(world, {{3, 2, 2}, {9, 4, 2}});
  EXPECT_EQ(extraction.count, 0);
}

TEST(CorridorBoxes, ACuboidAcrossAWordIsOneBox) {
  MarkedWorld world({130, 8, 6}, 0.5, 0.0);
  world.fill({60, 2, 1}, {129, 5, 4});
  Extraction extraction;
  extraction.run(world, whole(world));
  ASSERT_EQ(extraction.count, 1);
  const double lower[3] = {30.0, 1.0, 0.5};
  const double upper[3] = {64.5, 2.5, 2.0};
  for (int a = 0; a < 3; ++a) {
    EXPECT_EQ(extraction.boxes[0].lower[a], lower[a]);
    EXPECT_EQ(extraction.boxes[0].upper[a], upper[a]);
  }
}

TEST(CorridorBoxes, TheRangeCutsABox) {
  MarkedWorld world({130, 8, 6}, 1.0, 0.0);
  world.fill({0, 0, 0}, {130, 8, 6});
  Extraction extraction;
  extraction.run(world, {{62, 3, 2}, {66, 5, 5}});
  ASSERT_EQ(extraction.count, 1);
  const double lower[3] = {62.0, 3.0, 2.0};
  const double upper[3] = {66.0, 5.0, 5.0};
  for (int a = 0; a < 3; ++a) {
    EXPECT_EQ(extraction.boxes[0].lower[a], lower[a]);
    EXPECT_EQ(extraction.boxes[0].upper[a], upper[a]);
  }
}

TEST(CorridorBoxes, AStepIsTwoBoxes) {
  MarkedWorld world({8, 8, 8}, 1.0, 0.0);
  world.fill({1, 1, 1}, {5, 5, 3});
  world.fill({1, 1, 3}, {3, 5, 6});
  Extraction extraction;
  extraction.run(world, whole(world));
  EXPECT_EQ(extraction.count, 2);
}

TEST(CorridorBoxes, ReachTakesTheRadiusAndOneVoxelMoreAlongX) {
  const MarkedWorld world({40, 40, 40}, 0.1, 0.25);
  const VoxelRange range = voxels_within_reach(world.grid, {{1.0, 1.0, 1.0}, {2.0, 2.0, 2.0}});
  EXPECT_EQ(range.lower.y, 7);   // 1.0 - 0.25 is inside voxel 7
  EXPECT_EQ(range.upper.y, 23);  // 2.0 + 0.25 is inside voxel 22
  EXPECT_EQ(range.lower.z, 7);
  EXPECT_EQ(range.upper.z, 23);
  EXPECT_EQ(range.lower.x, 6);
  EXPECT_EQ(range.upper.x, 24);
}

TEST(CorridorBoxes, AVoxelThatOnlyTouchesTheReachIsLeftOut) {
  const MarkedWorld world({40, 40, 40}, 0.1, 0.3);
  const VoxelRange range = voxels_within_reach(world.grid, {{1.0, 1.0, 1.0}, {2.0, 2.0, 2.0}});
  EXPECT_EQ(range.lower.y, 7);   // voxel 6 ends at 0.7 = 1.0 - 0.3
  EXPECT_EQ(range.upper.y, 23);  // voxel 23 begins at 2.3
}

TEST(CorridorBoxes, TheReachEndsAtTheGrid) {
  const MarkedWorld world({10, 10, 10}, 0.1, 5.0);
  const VoxelRange range = voxels_within_reach(world.grid, {{0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}});
  EXPECT_EQ(range.lower.x, 0);
  EXPECT_EQ(range.upper.x, 10);
  EXPECT_EQ(range.lower.z, 0);
  EXPECT_EQ(range.upper.z, 10);
}

/// Every obstacle voxel of the range in exactly one box, no other voxel in any.
void expect_partition(const MarkedWorld& world, const VoxelRange& range, const Extraction& extraction) {
  const Voxel dims = world.grid.spec().dims;
  const double cell = world.grid.spec().cell;
  std::vector<int> covered(static_cast<std::size_t>(dims.x * dims.y * dims.z), 0);
  for (int i = 0; i < extraction.count; ++i) {
    int lower[3];
    int upper[3];
    for (int a = 0; a < 3; ++a) {
      lower[a] = static_cast<int>(std::lround(extraction.boxes[i].lower[a] / cell));
      upper[a] = static_cast<int>(std::lround(extraction.boxes[i].upper[a] / cell));
      ASSERT_LT(lower[a], upper[a]);
    }
    for (int z = lower[2]; z < upper[2]; ++z) {
      for (int y = lower[1]; y < upper[1]; ++y) {
        for (int x = lower[0]; x < upper[0]; ++x) ++covered[static_cast<std::size_t>((z * dims.y + y) * dims.x + x)];
      }
    }
  }
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int x = 0; x < dims.x; ++x) {
        const bool in_range = x >= range.lower.x && x < range.upper.x && y >= range.lower.y && y < range.upper.y &&
                              z >= range.lower.z && z < range.upper.z;
        const int expected = in_range && world.grid.obstacle({x, y, z}) ? 1 : 0;
        ASSERT_EQ(covered[static_cast<std::size_t>((z * dims.y + y) * dims.x + x)], expected);
      }
    }
  }
}

TEST(CorridorBoxes, PartitionTheObstaclesOfRandomRanges) {
  Random random(3);
  Extraction extraction;
  for (int i = 0; i < scaled(3000); ++i) {
    MarkedWorld world({random.integer(1, 150), random.integer(1, 8), random.integer(1, 6)}, 0.25, 0.0);
    const Voxel dims = world.grid.spec().dims;
    const double density = random.chance(0.5) ? random.real(0.0, 0.1) : random.real(0.0, 1.0);
    for (int k = 0; k < dims.x * dims.y * dims.z; ++k) {
      if (random.chance(density)) world.mark(k % dims.x, k / dims.x % dims.y, k / dims.x / dims.y);
    }
    VoxelRange range;
    range.lower = {random.integer(0, dims.x - 1), random.integer(0, dims.y - 1), random.integer(0, dims.z - 1)};
    range.upper = {random.integer(range.lower.x, dims.x), random.integer(range.lower.y, dims.y),
                   random.integer(range.lower.z, dims.z)};
    extraction.run(world, range);
    SCOPED_TRACE(i);
    ASSERT_GE(extraction.count, 0);
    ASSERT_NO_FATAL_FAILURE(expect_partition(world, range, extraction));
  }
}

/// More voxels apart from each other than there is room for boxes.
TEST(CorridorBoxes, MoreThanFitAreNone) {
  MarkedWorld world({64, 64, 32}, 0.5, 0.0);
  for (int z = 0; z < 32; z += 2) {
    for (int y = 0; y < 64; y += 2) {
      for (int x = 0; x < 64; x += 2) world.fill({x, y, z}, {x + 1, y + 1, z + 1});
    }
  }
  Extraction extraction;
  extraction.run(world, {{0, 0, 0}, {64, 64, 15}});
  EXPECT_EQ(extraction.count, tern::kMaxLocalBoxes);  // 32 * 32 * 8
  extraction.run(world, whole(world));
  EXPECT_EQ(extraction.count, -1);
}

}  // namespace
}  // namespace tern_test
