// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What every simulated depth image must show.
#ifndef TERN_TESTS_SUPPORT_PIXEL_AREAS_HPP
#define TERN_TESTS_SUPPORT_PIXEL_AREAS_HPP

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>

#include "host/flight/depth_camera.hpp"
#include "host/flight/flight_world.hpp"

namespace tern_test {

inline double depth_at(const tern_host::DepthFrame& frame, int u, int v) {
  return static_cast<double>(frame.depths[static_cast<std::size_t>(v * frame.view.width + u)]);
}

/// What a pixel shows is there: at its depth, a place of its area touches something, but for `slack` metres. And
/// nothing is nearer: before its depth, no place of its area is in anything. Looks at so many pixels.
/// `point_behind(u, v, depth)`: where a ray through a place of the image is at a depth.
template <typename PointBehind>
void expect_nearest_in_areas(const tern_host::FlightWorld& world, const tern_host::DepthFrame& frame, int pixels,
                             double slack, tern_host::Noise& random, const std::string& name,
                             PointBehind point_behind) {
  const double most = 1.5 * world.settings.sensor_range;
  for (int k = 0; k < pixels; ++k) {
    const int u = random.below(frame.view.width);
    const int v = random.below(frame.view.height);
    const double depth = depth_at(frame, u, v);
    double room = 1e9;
    for (int n = 0; n < 400; ++n) {
      const double du = random.within(-0.5, 0.5);
      const double dv = random.within(-0.5, 0.5);
      const double before = random.within(0.0, 1.0) * (depth - 1e-4);
      EXPECT_GT(clearance(world, point_behind(u + du, v + dv, before)), 0.0);
      room = std::min(room, clearance(world, point_behind(u + du, v + dv, depth + 1e-4)));
    }
    const double pixel = depth / frame.view.fx;
    EXPECT_LE(room, depth < most - 1e-4 ? slack + 0.2 * pixel : most) << name << " " << u << " " << v;
  }
}

}  // namespace tern_test

#endif
