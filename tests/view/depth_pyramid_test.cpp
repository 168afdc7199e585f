// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pyramids of depth images: how many levels they have, and what their coarsest levels say.
#include "view/depth_pyramid.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support/random.hpp"

namespace {

using tern::Depth;
using tern::DepthPyramid;
using tern::kPyramidLevels;
using tern::PixelBox;

struct OwnedPyramid {
  OwnedPyramid(std::int32_t width, std::int32_t height)
      : entries(static_cast<std::size_t>(DepthPyramid::entries(width, height)), Depth{1000}),
        pyramid(width, height, entries.data()) {}

  void make() {
    for (std::int32_t level = 1; level < pyramid.levels(); ++level) {
      for (std::int32_t row = 0; row < pyramid.height(level); ++row) pyramid.make_row(level, row);
    }
  }

  std::vector<Depth> entries;
  DepthPyramid pyramid;
};

/// 640 >> 8 is 2 and 480 >> 8 is 1: level 8 is the ninth one.
TEST(DepthPyramid, LevelsEndWhereTheShorterSideDoes) {
  EXPECT_EQ(OwnedPyramid(640, 480).pyramid.levels(), 9);
  EXPECT_EQ(OwnedPyramid(7, 1).pyramid.levels(), 1);
  EXPECT_EQ(DepthPyramid::entries(7, 1), 7);
  EXPECT_EQ(DepthPyramid::entries(5, 3), 5 * 3 + 2 * 3 * 2);
}

/// An image of 4096 x 2048 pixels could have a twelfth level of 2 x 1. The others have two layers of 2 * 4^k entries.
TEST(DepthPyramid, LargeImagesHaveElevenLevels) {
  OwnedPyramid large(4096, 2048);
  EXPECT_EQ(large.pyramid.levels(), kPyramidLevels);
  EXPECT_EQ(large.entries.size(), 4096u * 2048u + 2u * 2u * ((1u << 22) - 4u) / 3u);
  large.pyramid.row(2047)[4095] = 7;
  large.pyramid.row(0)[2048] = 3000;
  large.make();
  const PixelBox left{0, 2047, 0, 2047};
  const PixelBox right{2048, 4095, 0, 2047};
  const PixelBox whole{0, 4095, 0, 2047};
  ASSERT_EQ(large.pyramid.level_for(left), kPyramidLevels - 1);
  ASSERT_EQ(large.pyramid.level_for(right), kPyramidLevels - 1);
  EXPECT_EQ(large.pyramid.least(left, kPyramidLevels - 1), 1000);
  EXPECT_EQ(large.pyramid.most(left, kPyramidLevels - 1), 1000);
  EXPECT_EQ(large.pyramid.least(right, kPyramidLevels - 1), 7);
  EXPECT_EQ(large.pyramid.most(right, kPyramidLevels - 1), 3000);
  EXPECT_EQ(large.pyramid.level_for(whole), kPyramidLevels);  // no answer
}

/// A row of 7 pixels has one level: 6 of them are few enough to be looked at, 7 are not.
TEST(DepthPyramid, AsksForAsManyEntriesAsAreClose) {
  OwnedPyramid row(7, 1);
  row.pyramid.row(0)[6] = 7;
  EXPECT_EQ(row.pyramid.least_closely({0, 5, 0, 0}), 1000);
  EXPECT_EQ(row.pyramid.least_closely({1, 6, 0, 0}), 7);
  EXPECT_EQ(row.pyramid.least_closely({0, 6, 0, 0}), 0);  // no answer
}

/// Eight entries at a time, or one by one: the same answer for every rectangle of images wide and narrow.
TEST(DepthPyramid, ReachesWhatItsLeastDepthDoes) {
  tern_test::Random random(3);
  for (int k = 0; k < tern_test::scaled(400); ++k) {
    OwnedPyramid image(random.integer(1, 70), random.integer(1, 40));
    const DepthPyramid& pyramid = image.pyramid;
    for (Depth& depth : image.entries) depth = static_cast<Depth>(random.integer(0, tern::kDepthUnits));
    image.make();
    for (int n = 0; n < 50; ++n) {
      PixelBox box{random.integer(0, pyramid.width(0) - 1), 0, random.integer(0, pyramid.height(0) - 1), 0};
      box.u1 = random.integer(box.u0, pyramid.width(0) - 1);
      box.v1 = random.integer(box.v0, pyramid.height(0) - 1);
      const std::int32_t least = pyramid.least_closely(box);
      for (const std::int32_t far : {least, least + 1, random.integer(1, tern::kDepthUnits + 2)}) {
        ASSERT_EQ(far > 0 && pyramid.reaches(box, far), far > 0 && least >= far) << far;
      }
    }
  }
}

}  // namespace
