// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Copies of a grid, and grids that share a storage: what tells of the bits lies with the bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/grid_storage.hpp"
#include "tern/grid.hpp"

namespace {

using tern::Grid;
using tern::GridSpec;
using tern::Status;
using tern::Vec3;
using tern_test::OwnedGrid;
using tern_test::whole_grid;

GridSpec small() {
  return whole_grid({20, 15, 6}, 0.1, 0.1);
}

GridSpec large() {
  return whole_grid({90, 70, 9}, 0.1, 0.1);
}

void expect_not_bound(Grid grid) {
  const tern::Box box{{0.1, 0.1, 0.1}, {0.5, 0.5, 0.5}};
  const Vec3 point{0.25, 0.25, 0.25};
  EXPECT_FALSE(grid.bound());
  EXPECT_FALSE(grid.inflated());
  EXPECT_EQ(grid.mark_box(box), Status::kInvalidArgument);
  EXPECT_EQ(grid.clear_box(box), Status::kInvalidArgument);
  EXPECT_EQ(grid.mark_voxel({1, 1, 1}), Status::kInvalidArgument);
  EXPECT_EQ(grid.clear_voxel({1, 1, 1}), Status::kInvalidArgument);
  EXPECT_EQ(grid.mark_points(&point, 1), Status::kInvalidArgument);
  grid.inflate();
  EXPECT_FALSE(grid.inflated());
  EXPECT_EQ(grid.revision(), 0u);
  EXPECT_EQ(grid.version().words, nullptr);
}

TEST(GridCopies, AgreeOnWhatChanged) {
  OwnedGrid owned(large());
  Grid copy = owned.grid;
  ASSERT_EQ(owned.grid.mark_voxel({3, 3, 3}), Status::kOk);
  EXPECT_EQ(copy.revision(), owned.grid.revision());
  copy.inflate();
  EXPECT_TRUE(owned.grid.inflated());
  EXPECT_TRUE(owned.grid.version().equals(copy.version()));
  const tern::GridVersion before = copy.version();
  ASSERT_EQ(copy.mark_voxel({4, 4, 4}), Status::kOk);
  EXPECT_FALSE(owned.grid.inflated());
  owned.grid.inflate();
  EXPECT_FALSE(owned.grid.version().equals(before));
  EXPECT_FALSE(owned.grid.free({4, 4, 4}));
}

TEST(GridCopies, ABindThroughOneEndsTheOthers) {
  for (const GridSpec& spec : {small(), large()}) {
    OwnedGrid owned(large());
    owned.grid.inflate();
    Grid other = owned.grid;
    ASSERT_EQ(other.bind(spec, owned.words.data(), owned.words.size()), Status::kOk);
    other.inflate();
    const std::vector<std::uint64_t> words = owned.words;
    expect_not_bound(owned.grid);
    EXPECT_EQ(owned.words, words);
    Grid first;
    ASSERT_EQ(first.bind(spec, owned.words.data(), owned.words.size()), Status::kOk);
    expect_not_bound(other);
    EXPECT_TRUE(first.bound());
  }
}

TEST(GridCopies, OverwrittenStorageIsNotBound) {
  for (const std::uint64_t noise : {std::uint64_t{0}, ~std::uint64_t{0}, std::uint64_t{0xA5A5A5A5A5A5A5A5u}}) {
    OwnedGrid owned(small());
    owned.grid.inflate();
    std::fill(owned.words.begin(), owned.words.end(), noise);
    expect_not_bound(owned.grid);
    ASSERT_EQ(owned.grid.bind(small(), owned.words.data(), owned.words.size()), Status::kOk);
    EXPECT_TRUE(owned.grid.bound());
    EXPECT_EQ(tern_test::count_obstacles(owned.grid), 0);
  }
}

TEST(GridCopies, RevisionsGoOnInTheStorage) {
  OwnedGrid owned(small());
  ASSERT_EQ(owned.grid.mark_voxel({3, 3, 3}), Status::kOk);
  const std::uint64_t revision = owned.grid.revision();
  Grid fresh;
  ASSERT_EQ(fresh.bind(small(), owned.words.data(), owned.words.size()), Status::kOk);
  EXPECT_GT(fresh.revision(), revision);
}

TEST(GridCopies, RevisionsGoOnInTheGridWhoeverMarkedIt) {
  Grid grid;
  std::uint64_t revision = 0;
  for (int turn = 0; turn < 5; ++turn) {
    // Storage that is gone with the turn: the next bind does not read it.
    std::vector<std::uint64_t> words(tern::grid_words(small().dims));
    ASSERT_EQ(grid.bind(small(), words.data(), words.size()), Status::kOk);
    EXPECT_GT(grid.revision(), revision);
    Grid copy = grid;
    for (int k = 0; k < 10 - turn; ++k) ASSERT_EQ(copy.mark_voxel({k, 0, 0}), Status::kOk);
    EXPECT_GT(grid.revision(), revision);
    revision = grid.revision();
  }
}

TEST(GridCopies, AGridThatWasBoundElsewhereLeavesItsCopiesBound) {
  OwnedGrid owned(small());
  const Grid copy = owned.grid;
  std::vector<std::uint64_t> words(tern::grid_words(large().dims));
  ASSERT_EQ(owned.grid.bind(large(), words.data(), words.size()), Status::kOk);
  EXPECT_TRUE(copy.bound());
  EXPECT_TRUE(owned.grid.bound());
}

TEST(GridCopies, ARefusedBindLeavesGridAndWords) {
  OwnedGrid owned(small());
  ASSERT_EQ(owned.grid.mark_voxel({1, 1, 1}), Status::kOk);
  owned.grid.inflate();
  const std::vector<std::uint64_t> words = owned.words;
  const tern::GridVersion version = owned.grid.version();
  GridSpec bad = small();
  bad.cell = -1.0;
  Grid fresh;
  for (Grid* grid : {&owned.grid, &fresh}) {
    EXPECT_EQ(grid->bind(bad, owned.words.data(), owned.words.size()), Status::kInvalidArgument);
    EXPECT_EQ(grid->bind(small(), owned.words.data(), owned.words.size() - 1), Status::kInvalidArgument);
  }
  EXPECT_EQ(owned.words, words);
  EXPECT_TRUE(owned.grid.version().equals(version));
  EXPECT_FALSE(fresh.bound());
}

}  // namespace
