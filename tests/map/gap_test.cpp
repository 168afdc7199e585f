// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How near to the walls of a gap a camera sees voxels whole: what docs/map.md says where it chooses the cell.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/flown_world.hpp"

namespace {

using tern::MapSpec;
using tern::Status;
using tern_test::OwnedMap;

struct GapSensor {
  double pose_margin, depth_margin, depth_margin_square;
};

constexpr double kWallX = 4.0;
constexpr double kThick = 0.5;
constexpr double kLower = -1.6;  ///< of the window along y

/// Of the voxels in the gap that are at least `margin` from its sides: how many are not seen after a camera has come up
/// to the gap and into it. `counted` gets their number.
int unseen_in_gap(double width, double shift, double cell, const GapSensor& sensor, double margin, int& counted) {
  MapSpec spec = tern::map_spec({0.0, kLower, 0.9}, cell, {64, static_cast<int>(3.2 / cell), 1}, 0.0);
  spec.dims.x = cell < 0.15 ? 64 : 32;
  spec.dims.z = static_cast<int>(std::lround(1.2 / cell));
  spec.pose_margin = sensor.pose_margin;
  spec.depth_margin = sensor.depth_margin;
  spec.depth_margin_square = sensor.depth_margin_square;
  OwnedMap owned(spec);
  tern_test::Random random(71);
  const double lower = shift - 0.5 * width;
  const double upper = shift + 0.5 * width;
  tern_test::Scene scene;
  scene.boxes = {{{kWallX, -5.0, 0.0}, {kWallX + kThick, lower, 6.0}},
                 {{kWallX, upper, 0.0}, {kWallX + kThick, 5.0, 6.0}}};
  tern_test::LevelCamera camera;
  for (int k = 0; k < 16; ++k) {
    camera.render(scene, {0.5 + 0.25 * k, shift, 1.5}, 0.0);
    for (float& z : camera.image.z) {
      const double depth = static_cast<double>(z);
      const double error = sensor.depth_margin + sensor.depth_margin_square * depth * depth;
      z = static_cast<float>(depth + random.real(-error, error));
    }
    EXPECT_EQ(owned.map.begin_frame(camera.image.view, camera.pose, k), Status::kRunning);
    EXPECT_EQ(tern_test::finish(owned.map), Status::kOk);
  }
  int unseen = 0;
  const tern::Grid& safe = owned.map.safe();
  for (int y = 0; y < spec.dims.y; ++y) {
    const double at = kLower + y * cell;
    if (std::min(at - lower, upper - (at + cell)) < margin) continue;
    for (double x = kWallX + 0.5 * cell; x < kWallX + kThick; x += cell) {
      ++counted;
      unseen += safe.obstacle(safe.voxel_of(safe.to_local({x, at + 0.5 * cell, 1.5}))) ? 1 : 0;
    }
  }
  return unseen;
}

TEST(MapGap, IsSeenUpToTheMarginOfTheGuide) {
  constexpr double kPixel = 1.0 / 80.0;
  const GapSensor sensors[] = {{0.05, 0.03, 0.005}, {0.0, 0.0, 0.0}, {0.0, 0.03, 0.005}};
  const int looked = tern_test::scaled(3);
  int counted = 0;
  for (int k = 0; k < looked; ++k) {
    const GapSensor& sensor = sensors[k];
    for (const double cell : {0.1, 0.2}) {
      for (const double width : {0.9, 1.1, 1.2}) {
        const double error = sensor.depth_margin + 9.0 * sensor.depth_margin_square;  // of 3 m
        const double room = 0.5 * width * (cell + 2.0 * (sensor.pose_margin + error)) * kPixel;
        const double margin = sensor.pose_margin + 2.0 * std::sqrt(room);
        for (const double shift : {0.0, 0.3 * cell, 0.5 * cell}) {
          EXPECT_EQ(unseen_in_gap(width, shift, cell, sensor, margin, counted), 0)
              << cell << ' ' << width << ' ' << shift << ' ' << sensor.pose_margin << ' ' << sensor.depth_margin;
        }
      }
    }
  }
  EXPECT_GT(counted, 200 * looked);
}

}  // namespace
