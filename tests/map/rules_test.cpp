// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The rules of a rolling map on scenes that can be worked out by hand. The camera looks along x of the world: voxels of
// 0.1 m, a wall of pixels at one depth.
#include <gtest/gtest.h>

#include <limits>

#include "support/camera_map.hpp"
#include "support/owned_map.hpp"

namespace {

using tern::Box;
using tern::MapSpec;
using tern::Pose;
using tern::Status;
using tern::Vec3;
using tern::Voxel;
using tern_test::camera_spec;
using tern_test::finish;
using tern_test::Image;
using tern_test::OwnedMap;

constexpr double kHalf = 0.5;
/// Camera axes in the world: right is -y, down is -z, ahead is x.
constexpr double kAhead[4] = {kHalf, -kHalf, kHalf, -kHalf};

class MapRules : public ::testing::Test {
 protected:
  explicit MapRules(const MapSpec& spec = camera_spec()) : owned(spec), image(41, 41, 20.0) { wall(2.05); }

  void wall(double depth) {
    for (float& z : image.z) z = static_cast<float>(depth);
  }
  void frame(std::int64_t t = 0) {
    ASSERT_EQ(owned.map.begin_frame(image.view, {{1.0, 1.0, 1.0}, {kAhead[0], kAhead[1], kAhead[2], kAhead[3]}}, t),
              Status::kRunning);
    ASSERT_EQ(finish(owned.map), Status::kOk);
  }
  /// A voxel on the camera's axis, whose cube begins that many centimetres ahead of it, in tens.
  static Voxel ahead(int voxels) { return {10 + voxels, 10, 10}; }
  bool seen(int voxels) const { return owned.map.seen(ahead(voxels)); }
  bool solid(int voxels) const { return owned.map.route().obstacle(ahead(voxels)); }

  OwnedMap owned;
  Image image;
};

TEST_F(MapRules, NothingIsSeenAtFirst) {
  EXPECT_FALSE(seen(5));
  EXPECT_TRUE(owned.map.route().free(ahead(5)));
  EXPECT_FALSE(owned.map.safe().free(ahead(5)));
  EXPECT_TRUE(owned.map.safe().obstacle(ahead(5)));
  EXPECT_TRUE(owned.map.route().inflated());
  EXPECT_TRUE(owned.map.safe().inflated());
}

TEST_F(MapRules, AWallEndsWhatIsSeen) {
  frame();
  // Cubes end at 1.9 and 2.0 m, then the wall at 2.05 m.
  EXPECT_TRUE(seen(18));
  EXPECT_TRUE(seen(19));
  EXPECT_FALSE(seen(20));
  EXPECT_TRUE(solid(20));
  EXPECT_FALSE(seen(21));
  EXPECT_FALSE(solid(21));
  EXPECT_TRUE(owned.map.safe().free(ahead(19)));
  EXPECT_FALSE(owned.map.route().free(ahead(20)));
  EXPECT_FALSE(owned.map.safe().free(ahead(21)));
  EXPECT_TRUE(owned.map.route().free(ahead(21)));
}

TEST_F(MapRules, OnePixelHidesAllThatIsBehindIt) {
  image.at(20, 20) = 1.05f;
  frame();
  EXPECT_TRUE(seen(9));
  EXPECT_TRUE(solid(10));
  for (int k = 10; k < 20; ++k) EXPECT_FALSE(seen(k)) << k;
}

TEST_F(MapRules, APixelThatSaysNothingShowsNothing) {
  const float silent[] = {
      0.0f, -1.0f, 0.05f, 50.0f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()};
  for (const float z : silent) {
    OwnedMap fresh(camera_spec());
    image.at(20, 20) = z;
    ASSERT_EQ(fresh.map.begin_frame(image.view, {{1.0, 1.0, 1.0}, {kHalf, -kHalf, kHalf, -kHalf}}, 0),
              Status::kRunning);
    ASSERT_EQ(finish(fresh.map), Status::kOk);
    for (int k = 0; k < 20; ++k) EXPECT_FALSE(fresh.map.seen(ahead(k))) << z << ' ' << k;
    EXPECT_TRUE(fresh.map.seen({25, 10, 14}));
  }
}

TEST_F(MapRules, SixteenBitImages) {
  std::vector<std::uint16_t> numbers(image.z.size(), 2050);
  numbers[20 * 41 + 20] = 65535;
  image.view.z16 = numbers.data();
  image.view.z32 = nullptr;
  image.view.scale = 0.001;
  image.view.max = 70.0;
  frame();
  EXPECT_FALSE(seen(5));
  EXPECT_TRUE(owned.map.seen({25, 10, 14}));
  EXPECT_TRUE(owned.map.route().obstacle({30, 10, 14}));
}

TEST_F(MapRules, BeyondTheRangeNothingIsSeenOrHit) {
  wall(40.0);
  MapSpec spec = camera_spec();
  spec.range = 3.05;
  OwnedMap near(spec);
  ASSERT_EQ(near.map.begin_frame(image.view, {{1.0, 1.0, 1.0}, {kHalf, -kHalf, kHalf, -kHalf}}, 0), Status::kRunning);
  ASSERT_EQ(finish(near.map), Status::kOk);
  EXPECT_TRUE(near.map.seen(ahead(29)));
  EXPECT_FALSE(near.map.seen(ahead(30)));
  for (int k = 0; k < 54; ++k) EXPECT_FALSE(near.map.route().obstacle(ahead(k)));
}

TEST_F(MapRules, MarginsHoldBackWhatIsSeen) {
  MapSpec spec = camera_spec();
  spec.depth_margin = 0.1;
  spec.depth_margin_square = 0.02;  // 0.084 m at 2.05 m
  OwnedMap careful(spec);
  ASSERT_EQ(careful.map.begin_frame(image.view, {{1.0, 1.0, 1.0}, {kHalf, -kHalf, kHalf, -kHalf}}, 0),
            Status::kRunning);
  ASSERT_EQ(finish(careful.map), Status::kOk);
  // Seen up to 1.866 m.
  EXPECT_TRUE(careful.map.seen(ahead(17)));
  EXPECT_FALSE(careful.map.seen(ahead(18)));
  EXPECT_TRUE(careful.map.route().obstacle(ahead(20)));
}

TEST_F(MapRules, ThreeMissesClear) {
  frame();
  ASSERT_TRUE(solid(20));
  wall(4.05);
  frame();
  frame();
  EXPECT_TRUE(solid(20));
  EXPECT_TRUE(seen(20));
  EXPECT_FALSE(owned.map.safe().free(ahead(20)));
  frame();
  EXPECT_FALSE(solid(20));
  EXPECT_TRUE(owned.map.safe().free(ahead(20)));
  // The first hit blocks again.
  wall(2.05);
  frame();
  EXPECT_TRUE(solid(20));
}

TEST_F(MapRules, AHitStartsTheCountOfMissesAnew) {
  frame();
  for (const double depth : {4.05, 4.05, 2.05, 4.05, 4.05}) {
    wall(depth);
    frame();
    EXPECT_TRUE(solid(20));
  }
  frame();
  EXPECT_FALSE(solid(20));
}

TEST_F(MapRules, TwoHitsWhereAskedFor) {
  MapSpec spec = camera_spec();
  spec.hits = 2;
  OwnedMap noisy(spec);
  for (const bool blocked : {false, true}) {
    ASSERT_EQ(noisy.map.begin_frame(image.view, {{1.0, 1.0, 1.0}, {kHalf, -kHalf, kHalf, -kHalf}}, 0),
              Status::kRunning);
    ASSERT_EQ(finish(noisy.map), Status::kOk);
    EXPECT_EQ(noisy.map.route().obstacle(ahead(20)), blocked);
  }
}

TEST_F(MapRules, WhatAgesIsForgotten) {
  MapSpec spec = camera_spec();
  spec.age = 1000;
  OwnedMap ageing(spec);
  Pose pose{{1.0, 1.0, 1.0}, {kHalf, -kHalf, kHalf, -kHalf}};
  const auto enter = [&](std::int64_t t) {
    ASSERT_EQ(ageing.map.begin_frame(image.view, pose, t), Status::kRunning);
    ASSERT_EQ(finish(ageing.map), Status::kOk);
  };
  enter(0);
  EXPECT_TRUE(ageing.map.seen(ahead(10)));
  // The camera turns round: it looks along -x.
  pose.quaternion[2] = -kHalf;
  pose.quaternion[3] = kHalf;
  pose.position.x = 0.5;
  enter(500);
  enter(999);
  enter(1999);
  EXPECT_FALSE(ageing.map.seen(ahead(10)));
  EXPECT_TRUE(ageing.map.route().obstacle(ahead(20)));
  EXPECT_FALSE(ageing.map.safe().free(ahead(10)));
}

TEST_F(MapRules, MarksBlockUntilMissesClearThem) {
  const Vec3 point{1.55, 1.05, 1.05};
  ASSERT_EQ(owned.map.mark_points(&point, 1), Status::kOk);
  ASSERT_EQ(owned.map.mark_box({{1.7, 1.0, 1.0}, {1.8, 1.1, 1.1}}), Status::kOk);
  EXPECT_TRUE(solid(5));
  EXPECT_FALSE(solid(6));
  EXPECT_TRUE(solid(7));
  EXPECT_FALSE(solid(8));
  for (int k = 0; k < 3; ++k) {
    EXPECT_TRUE(solid(5));
    frame();
  }
  EXPECT_FALSE(solid(5));
  EXPECT_TRUE(seen(7));
}

TEST_F(MapRules, AFrameThatShowsNothingNewKeepsTheVersion) {
  frame();
  const tern::GridVersion route = owned.map.route().version();
  const tern::GridVersion safe = owned.map.safe().version();
  const std::uint64_t revision = owned.map.revision();
  frame();
  EXPECT_TRUE(owned.map.route().version().equals(route));
  EXPECT_TRUE(owned.map.safe().version().equals(safe));
  EXPECT_EQ(owned.map.revision(), revision);
  wall(4.05);
  frame();
  EXPECT_FALSE(owned.map.safe().version().equals(safe));
  EXPECT_GT(owned.map.revision(), revision);
}

TEST_F(MapRules, AScanShowsWhatItsBeamsPass) {
  MapSpec spec = camera_spec();
  spec.scan_pixel = 0.1;
  OwnedMap scanned(spec);
  const Vec3 eye{1.0, 1.0, 1.0};
  std::vector<Vec3> points;
  // Beams 0.04 apart, as tangents, onto a wall 2.05 m ahead; one of them onto something at half the way.
  for (int v = -25; v <= 25; ++v) {
    for (int u = -25; u <= 25; ++u) {
      const double t = u == 10 && v == 10 ? 1.05 : 2.05;
      points.push_back({eye.x + t, eye.y + t * 0.04 * u, eye.z + t * 0.04 * v});
    }
  }
  points.push_back({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0});
  ASSERT_EQ(scanned.map.begin_scan(points.data(), points.size(), eye, 0), Status::kRunning);
  ASSERT_EQ(finish(scanned.map), Status::kOk);
  EXPECT_TRUE(scanned.map.seen({28, 10, 10}));
  EXPECT_FALSE(scanned.map.seen({30, 10, 10}));
  EXPECT_TRUE(scanned.map.route().obstacle({30, 10, 10}));
  EXPECT_TRUE(scanned.map.route().obstacle({20, 14, 14}));
  EXPECT_FALSE(scanned.map.seen({27, 17, 17}));  // behind it
  EXPECT_FALSE(scanned.map.seen({5, 10, 10}));   // no beam went there
}

TEST_F(MapRules, AScanSkipsPointsThatAreNoneOrTooFar) {
  MapSpec spec = camera_spec();
  spec.scan_pixel = 0.1;
  OwnedMap scanned(spec);
  const std::uint64_t before = tern_test::hash_of(scanned.map);
  const double infinity = std::numeric_limits<double>::infinity();
  const Vec3 points[] = {{infinity, 1.0, 1.0}, {1.0, -infinity, 1.0}, {1.0, 1.0, infinity},
                         {-2e18, 1.0, 1.0},    {1.0, 2e18, 1.0},      {1.0, 1.0, 2e18}};
  ASSERT_EQ(scanned.map.begin_scan(points, 6, {1.0, 1.0, 1.0}, 0), Status::kRunning);
  ASSERT_EQ(finish(scanned.map), Status::kOk);
  EXPECT_EQ(tern_test::hash_of(scanned.map), before);
  ASSERT_EQ(scanned.map.begin_scan(nullptr, 0, {1.0, 1.0, 1.0}, 0), Status::kRunning);
  ASSERT_EQ(finish(scanned.map), Status::kOk);
  EXPECT_EQ(tern_test::hash_of(scanned.map), before);
}

/// An image of one pixel has no coarser level. The pixel's ray goes through the middle of a row of voxels.
TEST_F(MapRules, AnImageOfOnePixel) {
  Image one(1, 1, 1.0);
  one.at(0, 0) = 2.05f;
  ASSERT_EQ(owned.map.begin_frame(one.view, {{1.0, 1.05, 1.05}, {kHalf, -kHalf, kHalf, -kHalf}}, 0), Status::kRunning);
  ASSERT_EQ(finish(owned.map), Status::kOk);
  for (int k = 0; k < 54; ++k) EXPECT_EQ(solid(k), k == 20) << k;
  EXPECT_TRUE(seen(15));
  EXPECT_FALSE(seen(20));
}

TEST_F(MapRules, WorkIsBounded) {
  std::uint32_t units = 0;
  ASSERT_EQ(owned.map.begin_frame(image.view, {{1.0, 1.0, 1.0}, {kHalf, -kHalf, kHalf, -kHalf}}, 0), Status::kRunning);
  while (owned.map.step(1) == Status::kRunning) ++units;
  EXPECT_GT(units, 100u);
  EXPECT_LE(units, owned.map.frame_work(41, 41));
  EXPECT_EQ(owned.map.step(0), Status::kOk);
}

}  // namespace
