// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The numbers that tell the contents of the blocked layer's regions apart.
#include "grid/regions.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support/grid_storage.hpp"
#include "support/random.hpp"

namespace {

using tern::GridView;
using tern::Regions;
using tern::Voxel;
using tern_test::OwnedGrid;
using tern_test::Random;
using tern_test::whole_grid;

constexpr Voxel kDims{150, 140, 9};

std::vector<std::uint64_t> numbers(const tern::Grid& grid) {
  return {GridView::contents(grid), GridView::contents(grid) + Regions(grid.spec().dims).count()};
}

/// The words of a region.
std::vector<std::uint64_t> words(const tern::Grid& grid, int z, int block, int word) {
  std::vector<std::uint64_t> result;
  for (int y = block * tern::kBlockRows; y < (block + 1) * tern::kBlockRows && y < grid.spec().dims.y; ++y)
    result.push_back(grid.blocked_row(y, z)[word]);
  return result;
}

TEST(GridRegions, CountsPartsOfBlocksAndWords) {
  const Regions regions(kDims);
  EXPECT_EQ(regions.words, 3);
  EXPECT_EQ(regions.blocks, 3);
  EXPECT_EQ(regions.count(), 81);
  EXPECT_EQ(regions.at(8, 2, 2), 80);
}

TEST(GridRegions, OnlyRegionsNearAChangeGetAnotherNumber) {
  OwnedGrid world(whole_grid(kDims, 0.1, 0.1));
  world.grid.inflate();
  const std::vector<std::uint64_t> before = numbers(world.grid);
  ASSERT_EQ(world.grid.mark_voxel({10, 10, 4}), tern::Status::kOk);
  EXPECT_EQ(numbers(world.grid), before) << "the blocked layer is not made anew yet";
  world.grid.inflate();
  const std::vector<std::uint64_t> after = numbers(world.grid);
  const Regions regions(kDims);
  for (int z = 0; z < regions.planes; ++z) {
    for (int k = 0; k < regions.blocks * regions.words; ++k) {
      const bool near = k == 0 && z >= 2 && z <= 6;
      const std::size_t index = static_cast<std::size_t>(z * regions.blocks * regions.words + k);
      if (!near) {
        EXPECT_EQ(after[index], before[index]) << "plane " << z;
      }
    }
  }
  EXPECT_NE(after[static_cast<std::size_t>(regions.at(4, 0, 0))],
            before[static_cast<std::size_t>(regions.at(4, 0, 0))]);
}

/// Two grids that go through many changes, some of them the same: wherever and whenever numbers agree, words do.
TEST(GridRegions, EqualNumbersMeanEqualWords) {
  Random random(81);
  OwnedGrid first(whole_grid(kDims, 0.1, 0.15));
  OwnedGrid second(whole_grid(kDims, 0.1, 0.15));
  const Regions regions(kDims);
  int equal = 0;
  int different = 0;
  for (int round = 0; round < 40; ++round) {
    const Voxel at{random.integer(0, kDims.x - 1), random.integer(0, kDims.y - 1), random.integer(0, kDims.z - 1)};
    const Voxel other{random.integer(0, kDims.x - 1), at.y, at.z};
    const bool marks = random.chance(0.7);
    for (OwnedGrid* world : {&first, &second}) {
      const Voxel& voxel = world == &second && round > 20 ? other : at;
      ASSERT_EQ(marks ? world->grid.mark_voxel(voxel) : world->grid.clear_voxel(voxel), tern::Status::kOk);
      world->grid.inflate();
    }
    for (int z = 0; z < regions.planes; ++z) {
      for (int block = 0; block < regions.blocks; ++block) {
        for (int word = 0; word < regions.words; ++word) {
          const int k = regions.at(z, block, word);
          const bool same = GridView::contents(first.grid)[k] == GridView::contents(second.grid)[k];
          ++(same ? equal : different);
          if (same) {
            ASSERT_EQ(words(first.grid, z, block, word), words(second.grid, z, block, word)) << "round " << round;
          }
        }
      }
    }
  }
  EXPECT_GT(equal, 500);
  EXPECT_GT(different, 100);
}

TEST(GridRegions, WhatIsNotMadeYetIsNotWhatIsFree) {
  OwnedGrid world(whole_grid(kDims, 0.1, 0.1));
  const std::vector<std::uint64_t> unmade = numbers(world.grid);
  world.grid.inflate();
  const std::vector<std::uint64_t> made = numbers(world.grid);
  for (std::size_t k = 0; k < made.size(); ++k) EXPECT_NE(made[k], unmade[k]) << k;
  ASSERT_EQ(world.grid.bind(world.grid.spec(), world.words.data(), world.words.size()), tern::Status::kOk);
  EXPECT_EQ(numbers(world.grid), unmade);
  world.grid.inflate();
  EXPECT_EQ(numbers(world.grid), made);
}

/// Each bit of a change flips each bit of the number in half of all cases: changes do not cancel each other.
TEST(GridRegions, NumbersDependOnEveryBitOfAChange) {
  constexpr int kCases = 4000;
  Random random(82);
  for (int bit = 0; bit < 64; ++bit) {
    int flips[64] = {};
    for (int k = 0; k < kCases; ++k) {
      const std::uint64_t content = random.next();
      const std::uint64_t change = random.next() >> 16;
      const std::uint64_t other = change ^ std::uint64_t{1} << bit;
      const std::uint64_t flipped = tern::content_after(content, change) ^ tern::content_after(content, other);
      for (int k2 = 0; k2 < 64; ++k2) flips[k2] += static_cast<int>(flipped >> k2 & 1u);
    }
    for (const int count : flips) EXPECT_NEAR(count, kCases / 2, kCases / 20) << "bit " << bit;
  }
}

TEST(GridRegions, AnotherRadiusIsAnotherContent) {
  OwnedGrid narrow(whole_grid(kDims, 0.1, 0.1));
  OwnedGrid wide(whole_grid(kDims, 0.1, 0.2));
  for (OwnedGrid* world : {&narrow, &wide}) {
    world->grid.mark_voxel({70, 70, 4});
    world->grid.inflate();
  }
  for (int k = 0; k < Regions(kDims).count(); ++k)
    EXPECT_NE(GridView::contents(narrow.grid)[k], GridView::contents(wide.grid)[k]);
}

}  // namespace
