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

/// Operations of the piece with planes 8 to 11, each with 40 obstacles: in the same columns, or in others.
double operations(bool same_columns) {
  OwnedGrid owned(whole_grid({128, 64, 20}, 0.1, 0.5));
  for (int z = 0; z < 20; ++z) {
    tern_test::Random random(same_columns ? 61 : 61 + static_cast<std::uint64_t>(z));
    for (int k = 0; k < 40; ++k) {
      const int x = random.integer(0, 127);
      owned.grid.mark_voxel({x, random.integer(0, 63), z});
    }
  }
  tern::Work work;
  GridWords(owned.grid).inflate_piece(2, work);
  return static_cast<double>(-work.operations());
}

TEST(InflationWork, PlanesLikeTheOneBelowAreCopied) {
  EXPECT_LT(operations(true), 0.6 * operations(false));
}

}  // namespace
