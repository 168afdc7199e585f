// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstring>

#include "support/world.hpp"

namespace {

using namespace tern;

/// A wall of 1 m in the middle of a room of 4 x 4 x 2 m, with room to pass it.
tern_test::World room(double radius, double margin) {
  tern_test::World world({40, 40, 20}, 0.1, radius);
  world.spec.tracking_margin = margin;
  EXPECT_EQ(world.grid.bind(world.spec, world.words.data(), world.words.size()), Status::kOk);
  world.block({1.8, 1.2, 0.0}, {2.2, 3.0, 2.0}).from({0.75, 2.05, 1.05}).to({3.25, 2.05, 1.05});
  return world;
}

// 1/8 and 1/8 are 1/4 in doubles, so every stage computes with the same numbers.
TEST(TrackingMargin, CountsAsMuchAsTheRadius) {
  tern_test::World one = room(0.25, 0.0);
  tern_test::World both = room(0.125, 0.125);
  ASSERT_EQ(one.plan(), Status::kOk);
  ASSERT_EQ(both.plan(), Status::kOk);
  EXPECT_EQ(std::memcmp(&one.trajectory, &both.trajectory, sizeof one.trajectory), 0);
}

// 0.6 m are left between the wall and the room's side, and at most 0.3 m of clearance fit into that on both sides.
TEST(TrackingMargin, ClosesAGapThatTheBodyAloneWouldFit) {
  const auto shut = [](double margin) {
    tern_test::World world({40, 40, 20}, 0.1, 0.2);
    world.spec.tracking_margin = margin;
    EXPECT_EQ(world.grid.bind(world.spec, world.words.data(), world.words.size()), Status::kOk);
    world.block({1.8, 0.0, 0.0}, {2.2, 1.7, 2.0}).block({1.8, 2.3, 0.0}, {2.2, 4.0, 2.0});
    world.from({0.75, 2.05, 1.05}).to({3.25, 2.05, 1.05});
    return world.plan();
  };
  EXPECT_EQ(shut(0.0), Status::kOk);
  EXPECT_EQ(shut(0.2), Status::kNoPath);
}

TEST(TrackingMargin, HoldsForAMapThatIsDiscovered) {
  MapSpec spec = map_spec({0.0, 0.0, 0.0}, 0.1, {128, 64, 20}, 0.2);
  spec.tracking_margin = 0.15;
  std::vector<std::uint64_t> words(map_words(spec));
  RollingMap map;
  ASSERT_EQ(map.bind(spec, words.data(), words.size()), Status::kOk);
  EXPECT_EQ(map.route().spec().tracking_margin, 0.15);
  EXPECT_EQ(map.safe().spec().clearance(), 0.2 + 0.15);
}

TEST(TrackingMargin, OfHardlyAnythingIsNone) {
  tern_test::World world({40, 40, 20}, 0.1, 0.0);
  world.spec.tracking_margin = 1e-9;
  ASSERT_EQ(world.grid.bind(world.spec, world.words.data(), world.words.size()), Status::kOk);
  EXPECT_EQ(world.grid.spec().clearance(), 0.0);
}

}  // namespace
