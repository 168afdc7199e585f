// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Depth images that are near or far all over, and the largest image and scan that a map takes.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/owned_map.hpp"

namespace {

using namespace tern;
using tern_test::Image;
using tern_test::OwnedMap;

/// The camera looks along x, in the middle of the window.
const Pose kPose{{3.25, 3.25, 1.65}, {0.5, -0.5, 0.5, -0.5}};

MapSpec room() {
  MapSpec spec = map_spec({0.0, 0.0, 0.0}, 0.1, {128, 64, 32}, 0.3);
  spec.range = 5.0;
  spec.depth_margin = spec.pose_margin = 0.0;
  spec.pixels = 81 * 61;
  return spec;
}

struct Counts {
  int seen = 0, hit = 0;
};

Counts count(const RollingMap& map) {
  Counts counts;
  const Voxel& dims = map.safe().spec().dims;
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int x = 0; x < dims.x; ++x) {
        counts.seen += map.seen({x, y, z}) ? 1 : 0;
        counts.hit += map.route().obstacle({x, y, z}) ? 1 : 0;
      }
    }
  }
  return counts;
}

/// Enters the same image once, or a few times.
void enter(OwnedMap& owned, Image& image, double depth, int times = 1) {
  for (float& z : image.z) z = static_cast<float>(depth);
  for (int k = 0; k < times; ++k) {
    ASSERT_EQ(owned.map.begin_frame(image.view, kPose, 0), Status::kRunning);
    ASSERT_EQ(owned.map.step(owned.map.frame_work(image.view.width, image.view.height)), Status::kOk);
  }
}

/// 0.15 m ahead: the wall hits voxels on the plane there, and nothing behind it is seen.
TEST(MapExtremes, AllNear) {
  OwnedMap owned(room());
  Image image(81, 61, 40.0);
  enter(owned, image, 0.15);
  const Counts counts = count(owned.map);
  EXPECT_GT(counts.hit, 0);
  EXPECT_LE(counts.hit, 5 * 4);  // the pixels' centres spread over 0.3 by 0.23 m
  EXPECT_EQ(counts.seen, 0);     // no voxel of 0.1 m is whole between the camera and 0.15 m and inside the image
  for (int x = 34; x < 128; ++x) EXPECT_TRUE(owned.map.safe().obstacle({x, 32, 16})) << x;
  EXPECT_TRUE(owned.map.route().obstacle({34, 32, 16}));  // 3.25 + 0.15 m
}

/// Nearer than the sensor can measure: nothing is seen, nothing is hit, and what was seen stays.
TEST(MapExtremes, AllTooNear) {
  OwnedMap owned(room());
  Image image(81, 61, 40.0);
  enter(owned, image, 0.05);
  EXPECT_EQ(count(owned.map).seen, 0);
  EXPECT_EQ(count(owned.map).hit, 0);
  enter(owned, image, 4.0);
  const Counts before = count(owned.map);
  enter(owned, image, 0.0, 5);
  EXPECT_EQ(count(owned.map).seen, before.seen);
  EXPECT_EQ(count(owned.map).hit, before.hit);
}

/// Beyond the range: all of the view is seen up to the range, and nothing is hit.
TEST(MapExtremes, AllFar) {
  OwnedMap owned(room());
  Image image(81, 61, 40.0);
  enter(owned, image, 40.0);
  const Counts counts = count(owned.map);
  EXPECT_EQ(counts.hit, 0);
  for (int x = 36; x <= 81; ++x) EXPECT_TRUE(owned.map.seen({x, 32, 16})) << x;
  for (int x = 83; x < 128; ++x) EXPECT_FALSE(owned.map.seen({x, 32, 16})) << x;  // 3.25 + 5 m
  // The view's part of the window within the range: no more than the pyramid's volume in voxels, clipped above and
  // below.
  int inside = 0;
  for (int z = 0; z < 32; ++z) {
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 128; ++x) {
        const double ahead = (x + 0.5) * 0.1 - kPose.position.x;
        const double aside = std::abs((y + 0.5) * 0.1 - kPose.position.y);
        const double up = std::abs((z + 0.5) * 0.1 - kPose.position.z);
        inside += ahead > 0.0 && ahead < 5.0 && aside < ahead * 40.5 / 40.0 && up < ahead * 30.5 / 40.0 ? 1 : 0;
      }
    }
  }
  EXPECT_LT(counts.seen, inside);
  EXPECT_GT(counts.seen, inside / 2);
}

/// All far, then all near, then far again: hits block at once, and three misses clear them.
TEST(MapExtremes, NearAfterFar) {
  OwnedMap owned(room());
  Image image(81, 61, 40.0);
  enter(owned, image, 40.0);
  const int seen = count(owned.map).seen;
  enter(owned, image, 1.02);
  const int hit = count(owned.map).hit;
  EXPECT_GT(hit, 100);
  EXPECT_EQ(count(owned.map).seen, seen);  // seen once is seen, whatever is there now
  enter(owned, image, 40.0, 2);
  EXPECT_EQ(count(owned.map).hit, hit);
  enter(owned, image, 40.0);
  EXPECT_LT(count(owned.map).hit, hit / 2);  // voxels at the image's edges are not seen whole
}

/// The largest image that the spec allows; one pixel more is refused.
TEST(MapExtremes, LargestImage) {
  OwnedMap owned(room());
  Image largest(81, 61, 40.0);
  enter(owned, largest, 3.0);
  EXPECT_GT(count(owned.map).seen, 0);
  Image larger(81, 62, 40.0);
  EXPECT_EQ(owned.map.begin_frame(larger.view, kPose, 10), Status::kPixelsFull);
}

/// A scan of more points than there are pixels in its images, within the work that scan_work() says.
TEST(MapExtremes, LargestScan) {
  MapSpec spec = room();
  spec.scan_pixel = 0.05;
  spec.pixels = 6 * 50 * 50;
  OwnedMap owned(spec);
  ASSERT_EQ(owned.status, Status::kOk);
  tern_test::Random random(5);
  std::vector<Vec3> points;
  for (int k = 0; k < 200000; ++k) {
    Vec3 way{random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
    const double size = std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
    if (size < 0.1) continue;
    points.push_back({kPose.position.x + 2.0 * way.x / size, kPose.position.y + 2.0 * way.y / size,
                      kPose.position.z + 2.0 * way.z / size});
  }
  ASSERT_EQ(owned.map.begin_scan(points.data(), points.size(), kPose.position, 0), Status::kRunning);
  ASSERT_EQ(owned.map.step(owned.map.scan_work(points.size())), Status::kOk);
  const Counts counts = count(owned.map);
  // A sphere of 2 m, cut off at the floor and at the ceiling of the window.
  EXPECT_GT(counts.hit, 2000);
  EXPECT_TRUE(owned.map.seen({32, 32 + 12, 16}));
  EXPECT_TRUE(owned.map.seen({32 - 12, 32, 16}));
  EXPECT_FALSE(owned.map.seen({32, 32 + 23, 16}));
}

}  // namespace
