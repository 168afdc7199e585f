// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Free means seen, for random frames and scans, against a slower reference. tern_bench_seen runs as many as you like.
#include <gtest/gtest.h>

#include <string>

#include "support/seen_reference.hpp"
#include "support/seen_scan.hpp"

namespace {

using tern_test::Random;
using tern_test::scaled;
using tern_test::SeenCounts;

/// Not so careful that it sees little, though half of the frames allow for a wrong pose.
void expect_right(const SeenCounts& sum) {
  EXPECT_EQ(sum.wrong, 0);
  EXPECT_EQ(sum.missed, 0);
  EXPECT_EQ(sum.refused, 0);
  EXPECT_GT(sum.shown, sum.could_be / 2);
  EXPECT_GT(sum.hits, 1000);
  ::testing::Test::RecordProperty("shown", std::to_string(sum.shown));
  ::testing::Test::RecordProperty("could_be", std::to_string(sum.could_be));
}

TEST(MapSeen, EveryShownVoxelWasInFrontOfAllItsPixels) {
  Random random(301);
  SeenCounts sum;
  for (int k = 0; k < scaled(2000); ++k) sum.add(check_frame(random, tern_test::random_spec(random)));
  expect_right(sum);
}

TEST(MapSeen, EveryVoxelThatAScanShowsWasBehindNoBeamAndHadBeamsAllOverIt) {
  Random random(302);
  SeenCounts sum;
  for (int k = 0; k < scaled(300); ++k) sum.add(check_scan(random, tern_test::random_scan_spec(random)));
  expect_right(sum);
}

}  // namespace
