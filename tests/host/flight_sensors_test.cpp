// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the simulator's camera and lidar see of a world, and what their drivers make of that.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "host/flight/depth_camera.hpp"
#include "host/flight/flight_world.hpp"
#include "host/flight/lidar.hpp"
#include "host/flight/speckle_filter.hpp"
#include "support/pixel_areas.hpp"

namespace {

using tern_host::DepthFrame;
using tern_host::FlightWorld;
using tern_host::Noise;
using tern_host::read_flight_world;
using tern_test::depth_at;
using tern_test::expect_nearest_in_areas;

/// A camera's view of a world without errors.
DepthFrame clean_frame(FlightWorld world, const tern::Vec3& eye, double yaw) {
  world.settings.outliers = world.settings.depth_noise = 0.0;
  world.settings.speckle_filter = 0;
  Noise noise(1);
  return take_frame(world, eye, yaw, 0, noise);
}

/// Where a ray through a place of the image is at a depth.
tern::Vec3 point_behind(const DepthFrame& frame, const tern::Vec3& eye, double yaw, double u, double v, double depth) {
  const double right = (u - frame.view.cx) / frame.view.fx;
  const double down = (v - frame.view.cy) / frame.view.fy;
  return {eye.x + depth * (std::cos(yaw) + right * std::sin(yaw)),
          eye.y + depth * (std::sin(yaw) - right * std::cos(yaw)), eye.z - depth * down};
}

TEST(DepthCamera, ShowsTheNearestThingInAPixelsWholeArea) {
  Noise random(3);
  for (const char* const name : {"P12:1", "O:2", "S20:1", "M:3"}) {
    const FlightWorld world = read_flight_world(name, {});
    const double yaw = random.within(-3.0, 3.0);
    const DepthFrame frame = clean_frame(world, world.start, yaw);
    expect_nearest_in_areas(world, frame, 200, 0.0, random, name, [&](double u, double v, double depth) {
      return point_behind(frame, world.start, yaw, u, v, depth);
    });
  }
}

/// Wires, poles and shelves of a thousandth of a pixel, between its corners and borders.
TEST(DepthCamera, SeesWhatIsThinnerThanAPixel) {
  FlightWorld world;
  world.boundary = {{-2.0, -8.0, -4.0}, {14.0, 8.0, 4.0}};
  const tern::Vec3 eye{0.0, 0.01, 0.013};
  const auto pixels_at = [&](double depth, double yaw) {
    const DepthFrame frame = clean_frame(world, eye, yaw);
    return std::count_if(frame.depths.begin(), frame.depths.end(),
                         [depth](float z) { return std::abs(static_cast<double>(z) - depth) < 2e-4; });
  };
  world.blocks = {{{8.0, -7.0, 0.5}, {8.0001, 7.0, 0.5001}}};  // a wire across: a row of pixels
  EXPECT_GE(pixels_at(8.0, 0.0), 139);
  EXPECT_LE(pixels_at(8.0, 0.0), 141);
  world.blocks.clear();
  world.cylinders.push_back({8.0, 0.7, -3.9, 3.9, 5e-5});  // a pole: a column of pixels
  EXPECT_GE(pixels_at(8.0, 0.0), 70);
  EXPECT_LE(pixels_at(8.0, 0.0), 82);
  world.cylinders.clear();
  world.blocks = {{{3.0, -1.0, 0.5}, {6.0, 1.0, 0.5001}}};  // a shelf, from its edge: nothing behind it is nearer
  EXPECT_GE(pixels_at(3.0, 0.0), 52);
  world.blocks = {{{3.0, -1.0, 0.0131}, {6.0, 1.0, 0.0132}}};  // at the eye's height
  EXPECT_GE(pixels_at(3.0, 0.0), 52);
  world.blocks = {{{5.0, 2.0, 1.0}, {5.0001, 2.0001, 1.0001}}};  // a mote: one pixel, from everywhere
  for (const double yaw : {-0.2, 0.0, 0.1, 0.3, 0.6, 0.9}) {
    const DepthFrame frame = clean_frame(world, eye, yaw);
    const double depth = 5.0 * std::cos(yaw) + 1.99 * std::sin(yaw);
    EXPECT_GE(pixels_at(depth, yaw), 1) << yaw;
    EXPECT_LE(pixels_at(depth, yaw), 4) << yaw;
  }
}

TEST(SpeckleFilter, TakesOutLonePixelsAndKeepsThinThings) {
  constexpr int kSide = 9;
  std::vector<float> depths(kSide * kSide, 8.0f);
  depths[0 * kSide + 0] = 1.0f;                                                        // a lone pixel in the corner
  depths[4 * kSide + 2] = 2.0f;                                                        // one amid the wall
  depths[4 * kSide + 7] = 12.0f;                                                       // one that says too far
  for (int v = 2; v < 7; ++v) depths[static_cast<std::size_t>(v * kSide + 5)] = 3.0f;  // a thin pole
  tern_host::filter_speckle(depths, kSide, kSide, 0.0);
  for (int v = 0; v < kSide; ++v) {
    for (int u = 0; u < kSide; ++u) {
      const bool pole = u == 5 && v >= 2 && v <= 6;
      EXPECT_EQ(depths[static_cast<std::size_t>(v * kSide + u)], pole ? 3.0f : 8.0f) << u << " " << v;
    }
  }
}

/// Three pixels that touch across the first and last columns: one thing in a scan, lone pixels in an image.
TEST(SpeckleFilter, JoinsTheSidesOfAScan) {
  constexpr int kSide = 9;
  const std::size_t thing[3] = {4 * kSide, 4 * kSide + 8, 5 * kSide + 8};
  std::vector<double> clean(kSide * kSide, 8.0);
  std::vector<double> scan = clean;
  for (const std::size_t at : thing) scan[at] = 3.0;
  const std::vector<double> before = scan;
  std::vector<double> image = scan;
  tern_host::filter_speckle(scan, kSide, kSide, 0.0, tern_host::Sides::kJoined);
  EXPECT_EQ(scan, before);
  tern_host::filter_speckle(image, kSide, kSide, 0.0, tern_host::Sides::kApart);
  EXPECT_EQ(image, clean);
}

/// The least depth of a pixel and its neighbours.
float least_around(const DepthFrame& frame, int u, int v) {
  float least = 1e9f;
  for (int y = std::max(0, v - 1); y <= std::min(frame.view.height - 1, v + 1); ++y) {
    for (int x = std::max(0, u - 1); x <= std::min(frame.view.width - 1, u + 1); ++x) {
      least = std::min(least, frame.depths[static_cast<std::size_t>(y * frame.view.width + x)]);
    }
  }
  return least;
}

/// One pixel in a hundred: hardly any is left that is off by more than what counts as agreement.
TEST(SpeckleFilter, LeavesFewOutliers) {
  FlightWorld world = read_flight_world("P25:1", {});
  world.settings.outliers = 0.0;
  Noise clean_noise(1);
  const DepthFrame clean = take_frame(world, world.start, 0.0, 0, clean_noise);
  world.settings.outliers = 0.01;
  world.settings.speckle_filter = 1;
  Noise random(2);
  int wrong = 0;
  for (int k = 0; k < 20; ++k) {
    const DepthFrame frame = take_frame(world, world.start, 0.0, 0, random);
    for (int v = 0; v < frame.view.height; ++v) {
      for (int u = 0; u < frame.view.width; ++u) {
        const float depth = frame.depths[static_cast<std::size_t>(v * frame.view.width + u)];
        wrong += depth < 0.95f * least_around(clean, u, v) ? 1 : 0;
      }
    }
  }
  EXPECT_LE(wrong, 10);  // of 3840 outliers
}

/// A room with a trunk at 3 m on x: the beams that meet it end there, the others at the walls, floor and ceiling.
TEST(Lidar, BeamsEndWhereTheWorldBegins) {
  FlightWorld world;
  world.boundary = {{-4.0, -5.0, 0.0}, {6.0, 5.0, 3.0}};
  world.cylinders.push_back({3.0, 0.0, 0.0, 3.0, 0.5});
  world.settings.sensor = "lidar";
  world.settings.sensor_range = 20.0;
  Noise noise(1);
  const tern_host::LidarScan scan = take_scan(world, {0.0, 0.0, 1.5}, {0.1, 0.2, 1.6}, 7, noise);
  EXPECT_EQ(scan.taken, 7);
  EXPECT_EQ(scan.ranges.size(), tern_host::beam_count(world.settings));
  EXPECT_GT(scan.ranges.size(), 19000u);
  int on_trunk = 0;
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const tern::Vec3 point = scan.point(beam, static_cast<double>(scan.ranges[beam]));
    // Where it truly is. A beam shows the nearest thing in its part of the view, which is 0.02 rad wide.
    const tern::Vec3 p{point.x - 0.1, point.y - 0.2, point.z - 0.1};
    const double far = std::hypot(p.x, std::hypot(p.y, p.z - 1.5));
    EXPECT_GE(clearance(world, p), -0.015 * far);
    EXPECT_LE(clearance(world, p), 0.015 * far);
    on_trunk += std::abs(std::hypot(p.x - 3.0, p.y) - 0.5) < 0.05 ? 1 : 0;
  }
  EXPECT_GT(on_trunk, 200);
}

/// Wires, poles and motes of a thousandth of a beam's width: each place of them is shown by the beam in whose part it
/// is, no farther than it is. So the sensor keeps the map's promise (docs/map.md), with beams half a pixel apart.
TEST(Lidar, ShowsThinThingsInABeamsWholeWidth) {
  Noise random(5);
  FlightWorld world;
  world.boundary = {{-14.0, -14.0, -9.0}, {14.0, 14.0, 9.0}};
  world.settings.sensor = "lidar";
  const double high = world.settings.fov_vertical;
  const double beams_up = std::ceil(high / (0.5 * world.settings.scan_pixel));
  const double beams_around = std::ceil(2.0 * M_PI / (0.5 * world.settings.scan_pixel));
  for (int k = 0; k < 300; ++k) {
    const tern::Vec3 at{random.within(-9.0, 9.0), random.within(-9.0, 9.0), random.within(-2.0, 2.0)};
    if (std::hypot(at.x, at.y) < 4.0) continue;
    const double size = 1e-5 * (k % 2 + 1);
    const tern::Vec3 by{k % 4 == 0 ? 1.0 : size, k % 4 == 1 ? 1.0 : size, k % 4 == 2 ? 1.0 : size};
    world.cylinders.clear();
    world.blocks = {{{at.x, at.y, at.z}, {at.x + by.x, at.y + by.y, at.z + by.z}}};
    if (k % 8 == 6) world.cylinders.push_back({at.x, at.y, at.z, at.z + 1.0, size});
    if (k % 8 == 6) world.blocks.clear();
    const tern_host::LidarScan scan = take_scan(world, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0, random);
    for (int n = 0; n < 20; ++n) {
      const double along = world.blocks.empty() ? 0.0 : random.within(0.0, 1.0);
      const tern::Vec3 p{at.x + along * by.x, at.y + along * by.y, at.z + (world.blocks.empty() ? 0.5 : along * by.z)};
      const double azimuth = std::fmod(std::atan2(p.y, p.x) + 2.0 * M_PI, 2.0 * M_PI) / (2.0 * M_PI) * beams_around;
      const double elevation = (std::atan2(p.z, std::hypot(p.x, p.y)) / high + 0.5) * beams_up;
      const auto edge = [](double beams) { return std::abs(beams - std::round(beams)); };
      if (edge(azimuth) < 0.01 || edge(elevation) < 0.01) continue;
      const auto beam = static_cast<std::size_t>(std::floor(azimuth) * beams_up + std::floor(elevation));
      const double far = std::hypot(p.x, std::hypot(p.y, p.z));
      ASSERT_LE(static_cast<double>(scan.ranges[beam]), far + 1e-5) << k << " " << n;
      ASSERT_GE(static_cast<double>(scan.ranges[beam]), far - 1.0) << k << " " << n;
    }
  }
}

/// In a sky without returns, a beam is infinite.
TEST(Lidar, NothingComesBackFromFarAway) {
  FlightWorld world;
  world.boundary = {{-900.0, -900.0, -900.0}, {900.0, 900.0, 900.0}};
  world.settings.sensor = "lidar";
  Noise noise(1);
  const tern_host::LidarScan scan = take_scan(world, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0, noise);
  for (const float range : scan.ranges) ASSERT_TRUE(std::isinf(range) && range > 0.0f);
}

double length_of(const tern_host::LidarScan& scan, std::size_t beam) {
  return static_cast<double>(scan.ranges[beam]);
}

tern_host::LidarScan scan_at_start(const std::vector<std::string>& overrides, Noise& noise) {
  const FlightWorld world = read_flight_world("P25:1", overrides);
  return take_scan(world, world.start, world.start, 0, noise);
}

/// The least length of a beam and its neighbours. Scans have one column of beams after the other, 0.02 rad apart.
double least_around(const tern_host::LidarScan& scan, std::size_t beam) {
  constexpr int kColumns = 315;
  const int rows = static_cast<int>(scan.ranges.size()) / kColumns;
  const int column = static_cast<int>(beam) / rows;
  const int row = static_cast<int>(beam) % rows;
  double least = 1e9;
  for (int c = column + kColumns - 1; c <= column + kColumns + 1; ++c) {
    for (int r = std::max(0, row - 1); r <= std::min(rows - 1, row + 1); ++r) {
      least = std::min(least, length_of(scan, static_cast<std::size_t>(c % kColumns * rows + r)));
    }
  }
  return least;
}

/// How many beams of ten scans with one outlier in a hundred end before what a clean scan shows around them.
int wrong_beams(const std::string& filter) {
  Noise noise(2);
  const tern_host::LidarScan clean = scan_at_start({"sensor=lidar"}, noise);
  int wrong = 0;
  for (int k = 0; k < 10; ++k) {
    const tern_host::LidarScan scan = scan_at_start({"sensor=lidar", "outliers=0.01", filter}, noise);
    for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
      wrong += length_of(scan, beam) < 0.95 * least_around(clean, beam) ? 1 : 0;
    }
  }
  return wrong;
}

TEST(Lidar, FiltersLoneReturns) {
  EXPECT_GT(wrong_beams("speckle_filter=0"), 400);  // of 2050 outliers
  EXPECT_LE(wrong_beams("speckle_filter=1"), 10);
}

/// Where no neighbour is right either, a beam says that nothing is known.
TEST(Lidar, BeamsWithoutALengthAreNotANumber) {
  Noise noise(3);
  const tern_host::LidarScan scan = scan_at_start({"sensor=lidar", "outliers=1", "speckle_filter=1"}, noise);
  int unknown = 0;
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    unknown += std::isnan(length_of(scan, beam)) ? 1 : 0;
  }
  EXPECT_GT(unknown, 10);
}

}  // namespace
