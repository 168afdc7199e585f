// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A lidar whose thin beams fill its view bit by bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host/flight/lidar.hpp"
#include "host/flight/ray_length.hpp"
#include "host/flight/sensor_mount.hpp"

namespace {

using tern_host::FlightWorld;
using tern_host::LidarScan;
using tern_host::Noise;

FlightWorld room() {
  FlightWorld world;
  world.boundary = {{-4.0, -5.0, 0.0}, {6.0, 5.0, 3.0}};
  world.settings = tern_host::flight_settings({"sensor=livox", "mount=level", "mount_pitch=0"});
  return world;
}

double angle(const tern::Vec3& a, const tern::Vec3& b) {
  return std::acos(std::clamp(a.x * b.x + a.y * b.y + a.z * b.z, -1.0, 1.0));
}

LidarScan scan_of(const FlightWorld& world, std::uint64_t first) {
  Noise noise(1);
  const tern::Pose pose = lidar_pose(world.settings.mount, {0.0, 0.0, 1.5}, tern_host::level_attitude(0.3));
  return take_scattered_scan(world, pose, {0.0, 0.0, 1.5}, 0, first, noise);
}

/// Each scan keeps the map's promise for thin beams, and the next one has other beams.
TEST(ScatteredScan, LeavesNoGapInItsView) {
  const FlightWorld world = room();
  Noise random(2);
  for (const std::uint64_t first : {std::uint64_t{0}, std::uint64_t{20000}, std::uint64_t{123456789}}) {
    const LidarScan scan = scan_of(world, first);
    for (int k = 0; k < 200; ++k) {
      const double azimuth = random.within(-M_PI, M_PI);
      const double elevation = random.within(-0.10, 0.88);  // rad, inside -7 to 52 degrees
      const tern::Vec3 along{std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                             std::sin(elevation)};
      double nearest = M_PI;
      for (const tern::Vec3& beam : scan.directions) nearest = std::min(nearest, angle(beam, along));
      EXPECT_LE(nearest, 0.35 * world.settings.scan_pixel);
    }
  }
  EXPECT_GT(angle(scan_of(world, 0).directions[0], scan_of(world, 20000).directions[0]), 1e-3);
}

TEST(ScatteredScan, BeamsEndWhereTheWorldBegins) {
  FlightWorld world = room();
  world.cylinders.push_back({3.0, 0.0, 0.0, 3.0, 0.5});
  world.blocks.push_back({{-2.0, 1.0, 0.0}, {-1.0, 2.0, 2.0}});
  const LidarScan scan = scan_of(world, 7);
  ASSERT_EQ(scan.ranges.size(), 20000u);
  int on_trunk = 0;
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const double range = static_cast<double>(scan.ranges[beam]);
    const tern::Vec3 p = scan.point(beam, range);
    EXPECT_NEAR(clearance(world, p), 0.0, 1e-5);
    EXPECT_GT(clearance(world, scan.point(beam, 0.97 * range)), 0.0);
    on_trunk += std::abs(std::hypot(p.x - 3.0, p.y) - 0.5) < 1e-4 ? 1 : 0;
  }
  EXPECT_GT(on_trunk, 200);
}

TEST(RayLength, AlongAnAxis) {
  FlightWorld world = room();
  world.cylinders.push_back({2.0, 0.0, 1.0, 2.0, 0.25});
  EXPECT_DOUBLE_EQ(ray_length(world, {0.0, 0.0, 1.5}, {1.0, 0.0, 0.0}), 1.75);
  EXPECT_DOUBLE_EQ(ray_length(world, {2.0, 0.0, 2.5}, {0.0, 0.0, -1.0}), 0.5);
  EXPECT_DOUBLE_EQ(ray_length(world, {0.0, 0.0, 2.5}, {1.0, 0.0, 0.0}), 6.0);
  EXPECT_DOUBLE_EQ(ray_length(world, {0.0, 0.0, 1.5}, {0.0, 0.0, 1.0}), 1.5);
}

}  // namespace
