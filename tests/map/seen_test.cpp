// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Free means seen: random frames against a slower reference, random scans against the things in their worlds.
// tern_bench_seen runs as many as you like.
#include <gtest/gtest.h>

#include <string>

#include "support/seen_reference.hpp"
#include "support/seen_scan.hpp"

namespace {

using tern_test::Random;
using tern_test::scaled;
using tern_test::SeenCounts;

void expect_right(const SeenCounts& sum) {
  EXPECT_EQ(sum.wrong, 0);
  EXPECT_EQ(sum.missed, 0);
  EXPECT_EQ(sum.refused, 0);
  EXPECT_GT(sum.hits, 20 * sum.frames);
  ::testing::Test::RecordProperty("shown", std::to_string(sum.shown));
  ::testing::Test::RecordProperty("could_be", std::to_string(sum.could_be));
}

TEST(MapSeen, EveryShownVoxelWasInFrontOfAllItsPixels) {
  Random random(301);
  SeenCounts sum;
  for (int k = 0; k < scaled(2000); ++k) sum.add(check_frame(random, tern_test::random_spec(random)));
  expect_right(sum);
  // Half of the frames allow for a wrong pose. Without close looks at the pixels of voxels it is 0.68.
  EXPECT_GT(static_cast<double>(sum.shown), 0.71 * static_cast<double>(sum.could_be));
}

TEST(MapSeen, NoVoxelThatAScanShowsHoldsAThing) {
  Random random(302);
  SeenCounts sum;
  for (int k = 0; k < scaled(600); ++k) sum.add(check_scan(random, tern_test::random_scan_spec(random)));
  expect_right(sum);
  EXPECT_GT(sum.shown, 1000 * sum.frames);
  EXPECT_GT(sum.could_be, 20 * sum.frames);
}

}  // namespace
