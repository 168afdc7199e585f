// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pixels that nothing came back to: what they say is the user's statement, DepthView::no_return. The camera looks along
// x of the world; voxels of 0.1 m.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "map/support.hpp"
#include "support/grid_storage.hpp"
#include "support/owned_map.hpp"

namespace {

using tern::MapSpec;
using tern::Status;
using tern::Voxel;
using tern_test::Image;
using tern_test::OwnedMap;

constexpr float kEndless = std::numeric_limits<float>::infinity();
constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();
constexpr int kAxisPixel = 20;  ///< the pixel on the axis, along both of the image's

class MapNoReturn : public ::testing::Test {
 protected:
  MapNoReturn() : spec(tern::map_spec({0.0, 0.0, 0.0}, 0.1, {64, 20, 20}, 0.0)), image(41, 41, 20.0) {
    spec.depth_margin = spec.pose_margin = 0.0;
    spec.range = 5.0;
    spec.pixels = 4096;
    image.view.no_return = 3.05;
  }

  void fill(float depth) {
    for (float& z : image.z) z = depth;
  }
  Status begin(OwnedMap& owned) {
    return owned.map.begin_frame(image.view, {{1.0, 1.0, 1.0}, {0.5, -0.5, 0.5, -0.5}}, 0);
  }
  /// Voxels on the axis that one frame shows to be free, from the camera on.
  int seen_ahead() {
    OwnedMap owned(spec);
    EXPECT_EQ(begin(owned), Status::kRunning);
    EXPECT_EQ(tern_test::finish(owned.map), Status::kOk);
    int count = 0;
    while (count < 54 && owned.map.seen({11 + count, 10, 10})) ++count;
    hits = tern_test::count_obstacles(owned.map.route());
    return count;
  }

  MapSpec spec;
  Image image;
  int hits = 0;
};

TEST_F(MapNoReturn, SaysNothingUnlessItIsStated) {
  for (const float z : {0.0f, kEndless}) {
    fill(z);
    image.view.no_return = 0.0;
    EXPECT_EQ(seen_ahead(), 0);
    image.view.no_return = 3.05;
    EXPECT_EQ(seen_ahead(), 29);  // the voxels that end at 0.2 .. 3.0 m
    EXPECT_EQ(hits, 0);
  }
}

TEST_F(MapNoReturn, IsFreeUpToTheRangeAtMostAndHasNoError) {
  fill(0.0f);
  image.view.no_return = 1e300;
  EXPECT_EQ(seen_ahead(), 48);
  EXPECT_EQ(hits, 0);
  spec.depth_margin = 0.2;
  spec.depth_margin_square = 0.1;
  EXPECT_EQ(seen_ahead(), 48);
  image.view.no_return = 3.05;
  EXPECT_EQ(seen_ahead(), 29);
}

TEST_F(MapNoReturn, IsNeitherNotANumberNorADepthOutsideTheSensorsRange) {
  for (const float z : {kNoNumber, -kEndless, -1.0f, 0.05f, 50.0f}) {
    fill(0.0f);
    image.at(kAxisPixel, kAxisPixel) = z;
    EXPECT_EQ(seen_ahead(), 0) << z;
  }
}

TEST_F(MapNoReturn, IsZeroInImagesOfSixteenBits) {
  std::vector<std::uint16_t> numbers(image.z.size(), 0);
  image.view.z16 = numbers.data();
  image.view.z32 = nullptr;
  image.view.scale = 0.001;
  image.view.max = 70.0;
  EXPECT_EQ(seen_ahead(), 29);
  numbers[kAxisPixel * 41 + kAxisPixel] = 2050;
  EXPECT_EQ(seen_ahead(), 19);
  EXPECT_EQ(hits, 1);
  numbers[kAxisPixel * 41 + kAxisPixel] = 65535;
  EXPECT_EQ(seen_ahead(), 0);
}

TEST_F(MapNoReturn, IsRefusedIfItIsNotANumberOfMetres) {
  OwnedMap owned(spec);
  fill(1.0f);
  for (const double wrong : {-0.1, std::nan(""), static_cast<double>(kEndless)}) {
    image.view.no_return = wrong;
    EXPECT_EQ(begin(owned), Status::kCameraInvalid) << wrong;
  }
}

/// A hole in a surface is no way through it, and a lone pixel is no thing in the sky.
TEST_F(MapNoReturn, CountsWithSupportIfNeighboursHaveNoneEither) {
  spec.support = 1;
  fill(2.05f);
  image.at(kAxisPixel, kAxisPixel) = 0.0f;
  EXPECT_EQ(seen_ahead(), 19);
  fill(0.0f);
  EXPECT_EQ(seen_ahead(), 29);
  image.at(kAxisPixel, kAxisPixel) = 2.05f;
  EXPECT_EQ(seen_ahead(), 19);
  EXPECT_EQ(hits, 0);
}

TEST(MapSupport, NoReturnAgreesWithItselfAlone) {
  const tern::Support support{0.25f, 0.125f, 0.01f, 2};
  const float rows[3][3] = {{kEndless, 9, 9}, {9, kEndless, 9}, {9, 9, kEndless}};
  EXPECT_EQ(tern::judge_pixel<true>(support, rows[0], rows[1], rows[2]).sees, kEndless);
  const float alone[3][3] = {{kEndless, 9, 9}, {9, kEndless, 8}, {9, 9, 9}};
  EXPECT_EQ(tern::judge_pixel<true>(support, alone[0], alone[1], alone[2]).sees, 8.0f);
  const float measured[3][3] = {{kEndless, kEndless, kEndless}, {kEndless, 8, kEndless}, {kEndless, kEndless, 8}};
  EXPECT_EQ(tern::judge_pixel<true>(support, measured[0], measured[1], measured[2]).sees, 8.0f);
  EXPECT_EQ(tern::judge_pixel<true>(support, measured[0], measured[1], measured[2]).hits, 0.0f);
}

}  // namespace
