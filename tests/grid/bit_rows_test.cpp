// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid/bit_rows.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "support/grid_storage.hpp"

namespace {

using tern::bits_before;
using tern::bits_from;
using tern::bits_met;
using tern::bits_within;
using tern::GridAccess;
using tern::kAllBits;
using tern_test::OwnedGrid;
using tern_test::whole_grid;

TEST(GridBitRows, MasksHoldTheBitsOfARange) {
  EXPECT_EQ(bits_from(3), kAllBits - 7);
  EXPECT_EQ(bits_from(64), kAllBits);
  EXPECT_EQ(bits_before(67), 7u);
  EXPECT_EQ(bits_before(64), 0u);
  EXPECT_EQ(bits_within({1, 3}, 0), 6u);
  EXPECT_EQ(bits_within({60, 130}, 0), std::uint64_t{15} << 60);
  EXPECT_EQ(bits_within({60, 130}, 1), kAllBits);
  EXPECT_EQ(bits_within({60, 130}, 2), 3u);
  EXPECT_EQ(bits_within({64, 128}, 1), kAllBits);
}

TEST(GridBitRows, ARangeThatMissesTheWordHasNoBitsInIt) {
  EXPECT_EQ(bits_met({-5, 2}, 0), 3u);
  EXPECT_EQ(bits_met({60, 130}, 0), std::uint64_t{15} << 60);
  EXPECT_EQ(bits_met({60, 64}, 1), 0u);
  EXPECT_EQ(bits_met({128, 130}, 1), 0u);
  EXPECT_EQ(bits_met({70, 70}, 1), 0u);
  EXPECT_EQ(bits_met({90, 70}, 1), 0u);
  EXPECT_EQ(bits_met({-9, 0}, 0), 0u);
}

TEST(GridBitRows, RowsLieWhereTheGridSaysTheyDo) {
  OwnedGrid owned(whole_grid({130, 5, 4}, 0.1, 0.2));
  const tern::BitRows obstacles = GridAccess::obstacles(owned.grid);
  const tern::BitRows blocked = GridAccess::blocked(owned.grid);
  EXPECT_EQ(obstacles.row_words, 3);
  EXPECT_EQ(obstacles.index(2, 3), 3 * (5 * 3 + 2));
  EXPECT_EQ(obstacles.index(-1, 0), -3);
  EXPECT_EQ(GridAccess::layer_words(owned.grid), 60u);
  EXPECT_EQ(obstacles.row(2, 3), owned.grid.obstacle_row(2, 3));
  EXPECT_EQ(blocked.row(4, 1), owned.grid.blocked_row(4, 1));
}

TEST(GridBitRows, AnotherBlockedLayerChangesNothingElse) {
  OwnedGrid owned(whole_grid({130, 5, 4}, 0.1, 0.2));
  std::vector<std::uint64_t> words(GridAccess::layer_words(owned.grid), 0);
  const tern::Grid view = GridAccess::with_blocked(owned.grid, words.data());
  EXPECT_TRUE(view.free({1, 2, 3}));
  EXPECT_FALSE(owned.grid.free({1, 2, 3}));
  EXPECT_EQ(view.obstacle_row(1, 1), owned.grid.obstacle_row(1, 1));
}

}  // namespace
