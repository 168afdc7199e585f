// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What an inflation takes: a plane is made from the one below where that is cheaper, and only there.
#include <gtest/gtest.h>

#include <cstdint>

#include "map/grid_words.hpp"
#include "support/grid_storage.hpp"
#include "support/random.hpp"

namespace {

using tern::GridWords;
using tern_test::OwnedGrid;
using tern_test::whole_grid;

/// Instructions of the piece with planes 8 to 11, each with 40 obstacles: in the same columns, or in others.
double effort(bool same_columns) {
  OwnedGrid owned(whole_grid({128, 64, 20}, 0.1, 0.5));
  for (int z = 0; z < 20; ++z) {
    tern_test::Random random(same_columns ? 61 : 61 + static_cast<std::uint64_t>(z));
    for (int k = 0; k < 40; ++k) {
      const int x = random.integer(0, 127);
      owned.grid.mark_voxel({x, random.integer(0, 63), z});
    }
  }
  return GridWords(owned.grid).inflate_piece(2);
}

TEST(InflationEffort, PlanesLikeTheOneBelowAreCopied) {
  EXPECT_LT(effort(true), 0.6 * effort(false));
}

}  // namespace
