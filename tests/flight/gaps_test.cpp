// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Gaps as wide as docs/map.md asks for, wherever the voxels lie.
#include <gtest/gtest.h>

#include <cmath>

#include "support/flown.hpp"

namespace {

using tern::FlightReason;
using tern_test::Flown;

/// A wall with a gap across a room without another way.
tern_test::Scene walled(double middle, double width) {
  const auto wall = [middle](double x0, double y0, double x1, double y1) {
    return tern::Box{{x0, middle + y0, 0.0}, {x1, middle + y1, 6.0}};
  };
  tern_test::Scene scene;
  scene.boxes = {wall(4.0, -4.0, 4.5, -0.5 * width), wall(4.0, 0.5 * width, 4.5, 4.0), wall(-2.0, -4.2, 9.0, -4.0),
                 wall(-2.0, 4.0, 9.0, 4.2),          wall(-2.2, -4.2, -2.0, 4.2),      wall(9.0, -4.2, 9.2, 4.2)};
  return scene;
}

void expect_passed(double radius, double cell) {
  const double row = std::ceil(radius / cell - 1e-9);  // voxels to each side of the one that the plan leads through
  double width = 2.0 * (row + 1.0) * cell;
  // To each side, what the camera of 160 pixels sees no voxel in.
  width += 2.0 * 2.0 * std::sqrt(0.5 * width * (cell + 0.04) / 80.0);
  for (const double shift : {0.0, 0.25, 0.5}) {
    SCOPED_TRACE(shift);
    tern_test::FlightSettings settings;
    settings.radius = radius;
    settings.cell = cell;
    settings.window = cell < 0.15 ? tern::Voxel{256, 128, 32} : tern::Voxel{128, 64, 20};
    settings.work_per_tick = 8000;
    Flown flown(walled(shift * cell, width), settings);
    ASSERT_EQ(flown.started, tern::Status::kOk);
    ASSERT_EQ(flown.flight.set_goal({7.5, shift * cell, 1.5}), tern::Status::kOk);
    EXPECT_EQ(flown.fly(15.0), FlightReason::kArrived) << radius << ' ' << cell << ' ' << width;
  }
}

TEST(Gaps, OfTwoRadiiTwoCellsAndTheMarginArePassed) {
  const double radii[] = {0.4, 0.35, 0.4};
  const double cells[] = {0.2, 0.175, 0.1};
  for (int k = 0; k < tern_test::scaled(3); ++k) expect_passed(radii[k], cells[k]);
}

}  // namespace
