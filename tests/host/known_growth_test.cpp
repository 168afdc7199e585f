// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/page/known_growth.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace {

using tern_host::RunJson;

/// A map of 128 x 20 x 10 voxels of 0.5 m, from (0, 0, 0) to (64, 10, 5).
class KnownGrowthTest : public testing::Test {
 protected:
  void SetUp() override {
    tern::MapSpec spec = tern::map_spec({0, 0, 0}, 0.5, {128, 20, 10}, 0.5);
    spec.slack = 0;
    words_.resize(tern::map_words(spec));
    ASSERT_EQ(map_.bind(spec, words_.data(), words_.size()), tern::Status::kOk);
  }

  std::vector<std::uint64_t> words_;
  tern::RollingMap map_;
  tern_host::KnownGrowth growth_{{{1, 1, 1}, {40, 9, 4}}};
};

TEST_F(KnownGrowthTest, BlocksHaveTheTimeOfTheirFirstLook) {
  growth_.note(0.0, map_);
  map_.mark_box({{10.1, 2.1, 1.1}, {10.4, 2.9, 2.9}});  // x 20, y 4 to 5, z 2 to 5
  growth_.note(1.0, map_);
  map_.mark_box({{10.1, 3.1, 1.1}, {10.4, 3.4, 2.9}});  // y 6
  growth_.note(1.1, map_);                              // too soon after the last look
  growth_.note(2.0, map_);
  EXPECT_EQ(growth_.known_json().at("blocks"), RunJson({20, 4, 2, 2, 4, 1.0, -1.0, 20, 6, 2, 1, 4, 2.0, -1.0}));
}

TEST_F(KnownGrowthTest, WhatIsOutsideTheBoundsIsLeftOut) {
  map_.mark_box({{0.1, 0.1, 0.1}, {63.9, 0.4, 4.9}});  // a wall at y below 1
  map_.mark_box({{2.1, 2.1, 0.1}, {2.4, 2.4, 4.9}});   // a pillar from floor to ceiling: z 2 to 7 are within
  growth_.note(0.5, map_);
  EXPECT_EQ(growth_.known_json().at("blocks"), RunJson({4, 4, 2, 1, 6, 0.5, -1.0}));
}

TEST_F(KnownGrowthTest, TheFloorHasTheTimeOfTheFirstLook) {
  growth_.note(0.0, map_);
  ASSERT_EQ(map_.assume_free({5.25, 5.25, 2.25}, 0.45), tern::Status::kOk);  // voxel (10, 10, 4) and no other
  growth_.note(1.0, map_);
  const RunJson seen = growth_.seen_json();
  // Columns 2 to 79 along x, 2 to 17 along y.
  EXPECT_EQ(seen.at("size"), RunJson({78, 16}));
  for (std::size_t i = 0; i < seen.at("times").size(); ++i) {
    EXPECT_EQ(seen.at("times")[i].get<int>(), i == (10 - 2) * 78 + (10 - 2) ? 10 : -1) << i;
  }
}

TEST_F(KnownGrowthTest, ASlideMovesNothing) {
  map_.mark_box({{20.1, 2.1, 1.1}, {20.4, 2.4, 1.4}});
  growth_.note(0.0, map_);
  map_.follow({60.0, 5.0, 2.5});
  while (map_.busy()) map_.step(1000);
  map_.mark_box({{36.1, 2.1, 1.1}, {36.4, 2.4, 1.4}});
  growth_.note(1.0, map_);
  // The first voxel has left the window, and stays.
  EXPECT_EQ(growth_.known_json().at("blocks"), RunJson({40, 4, 2, 1, 1, 0.0, -1.0, 72, 4, 2, 1, 1, 1.0, -1.0}));
}

}  // namespace
