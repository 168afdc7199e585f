// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the ranges of beams say to a map, and what the scanners of docs/map.md show of an empty sky.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/numbers.hpp"
#include "support/owned_map.hpp"
#include "support/scan_patterns.hpp"

namespace {

using tern::Beams;
using tern::MapSpec;
using tern::Status;
using tern::Vec3;
using tern::Voxel;
using tern_test::finish;
using tern_test::kInfinity;
using tern_test::OwnedMap;

constexpr Vec3 kEye{1.05, 1.05, 1.05};

MapSpec exact_spec() {
  MapSpec spec = tern::map_spec({0.0, 0.0, 0.0}, 0.1, {64, 21, 21}, 0.0);
  spec.depth_margin = 0.0;
  spec.pose_margin = 0.0;
  spec.range = 4.0;
  spec.scan_pixel = 0.05;
  return spec;
}

/// A fan of beams along x, 0.02 apart, of which the middle one may say something else.
class MapBeams : public ::testing::Test {
 protected:
  MapBeams() : owned(exact_spec()) {
    for (int v = -20; v <= 20; ++v) {
      for (int u = -20; u <= 20; ++u) directions.push_back({2.0, 0.04 * u, 0.04 * v});
    }
    ranges.assign(directions.size(), INFINITY);
  }
  float& middle() { return ranges[ranges.size() / 2]; }
  Beams beams() const { return {directions.data(), ranges.data(), ranges.size(), 0.3, 30.0}; }
  void enter() {
    ASSERT_EQ(owned.map.begin_scan(beams(), kEye, 0), Status::kRunning);
    ASSERT_EQ(finish(owned.map), Status::kOk);
  }
  bool seen(int x) const { return owned.map.seen({x, 10, 10}); }
  bool solid(int x) const { return owned.map.route().obstacle({x, 10, 10}); }

  OwnedMap owned;
  std::vector<Vec3> directions;
  std::vector<float> ranges;
};

TEST_F(MapBeams, NothingCameBackShowsAllUpToTheRange) {
  enter();
  EXPECT_TRUE(seen(30));
  EXPECT_TRUE(seen(47));
  EXPECT_FALSE(seen(51));
  for (int x = 0; x < 64; ++x) EXPECT_FALSE(solid(x)) << x;
}

TEST_F(MapBeams, WhatIsKnownOfNothingShowsNothing) {
  for (const float says : {NAN, -INFINITY, 0.0f, -2.0f, 0.29f, 30.0f, 3e38f}) {
    middle() = says;
    enter();
    for (int x = 0; x < 64; ++x) EXPECT_FALSE(seen(x) || solid(x)) << x << " with " << says;
  }
  EXPECT_TRUE(owned.map.seen({30, 15, 10}));  // beside it
}

TEST_F(MapBeams, AReturnHitsItsVoxelAndHidesWhatIsBehind) {
  middle() = 2.0f;
  enter();
  EXPECT_TRUE(seen(25));
  EXPECT_TRUE(solid(30));
  EXPECT_FALSE(seen(32));
  EXPECT_TRUE(owned.map.seen({32, 16, 10}));
}

TEST_F(MapBeams, EqualPointsAtTheSamePlaces) {
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    ranges[k] = 1.0f + static_cast<float>(k % 7) * 0.25f;
    const Vec3& d = directions[k];
    const double scale = static_cast<double>(ranges[k]) / std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
    points.push_back({kEye.x + scale * d.x, kEye.y + scale * d.y, kEye.z + scale * d.z});
  }
  enter();
  OwnedMap by_points(exact_spec());
  ASSERT_EQ(by_points.map.begin_scan(points.data(), points.size(), kEye, 0), Status::kRunning);
  ASSERT_EQ(finish(by_points.map), Status::kOk);
  EXPECT_EQ(tern_test::hash_of(owned.map), tern_test::hash_of(by_points.map));
}

TEST_F(MapBeams, DirectionsThatAreNoneAreSkipped) {
  const std::uint64_t before = tern_test::hash_of(owned.map);
  directions = {{0, 0, 0}, {kInfinity, 0, 0}, {0, std::nan(""), 1}, {1e300, 1e300, 0}, {1e-200, 0, 0}};
  ranges.assign(directions.size(), 1.0f);
  enter();
  EXPECT_EQ(tern_test::hash_of(owned.map), before);
}

TEST_F(MapBeams, WorkIsBounded) {
  ASSERT_EQ(owned.map.begin_scan(beams(), kEye, 0), Status::kRunning);
  EXPECT_EQ(owned.map.step(owned.map.scan_work(ranges.size())), Status::kOk);
}

/// The share of voxels seen within a cone around the horizon, from `near` to `far` metres.
double share(const std::vector<Vec3>& directions, double pixel, double lowest, double highest, double near) {
  MapSpec spec = tern::map_spec({-8.0, -8.0, -4.0}, 0.2, {80, 80, 40}, 0.3);
  spec.range = 8.0;
  spec.scan_pixel = pixel;
  OwnedMap owned(spec);
  const std::vector<float> ranges(directions.size(), INFINITY);
  const Beams beams{directions.data(), ranges.data(), ranges.size(), 0.3, 100.0};
  EXPECT_EQ(owned.map.begin_scan(beams, {0, 0, 0}, 0), Status::kRunning);
  finish(owned.map);
  int all = 0, seen = 0;
  for (int k = 0; k < 80 * 80 * 40; ++k) {
    const Voxel v{k % 80, k / 80 % 80, k / 6400};
    const Vec3 c{-7.9 + 0.2 * v.x, -7.9 + 0.2 * v.y, -3.9 + 0.2 * v.z};
    const double flat = std::hypot(c.x, c.y), far = std::hypot(flat, c.z), elevation = std::atan2(c.z, flat);
    if (far < near || far > 7.0 || elevation < lowest || elevation > highest) continue;
    ++all;
    seen += owned.map.seen(v) ? 1 : 0;
  }
  return static_cast<double>(seen) / all;
}

constexpr double kDegree = tern_test::kTurn / 360.0;

/// 16 rings, 2 degrees apart, 0.2 degrees from one beam to the next.
TEST(Scanners, SixteenRingsSeeAroundTheHorizon) {
  std::vector<Vec3> beams;
  for (int ring = 0; ring < 16; ++ring) {
    for (int k = 0; k < 1800; ++k) beams.push_back(tern_test::direction(0.2 * k * kDegree, (2 * ring - 15) * kDegree));
  }
  const double middle = share(beams, 0.08, -4 * kDegree, 4 * kDegree, 3.0);
  const double finer = share(beams, 0.035, -5 * kDegree, 5 * kDegree, 3.0);
  const double above = share(beams, 0.08, 14 * kDegree, 90 * kDegree, 3.0);
  RecordProperty("middle", std::to_string(middle));
  RecordProperty("finer", std::to_string(finer));
  EXPECT_GT(middle, 0.9);
  EXPECT_LT(finer, 0.05);  // rows of pixels without a beam
  EXPECT_EQ(above, 0.0);
}

/// 20,000 beams by chance, from 7 degrees below to 52 degrees above the horizon: a tenth of a second of 200,000 a
/// second.
TEST(Scanners, ARosetteSeesItsView) {
  tern_test::Random random(7);
  tern_test::Pattern pattern;
  pattern.lowest = -7 * kDegree;
  pattern.highest = 52 * kDegree;
  tern_test::add_rosette(random, pattern, 20000, false);
  const double coarse = share(pattern.beams, 0.07, 5 * kDegree, 35 * kDegree, 3.0);
  const double fine = share(pattern.beams, 0.035, 5 * kDegree, 35 * kDegree, 3.0);
  RecordProperty("coarse", std::to_string(coarse));
  RecordProperty("fine", std::to_string(fine));
  EXPECT_GT(coarse, 0.95);
  EXPECT_LT(fine, 0.1);
}

}  // namespace
