// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_PORTS_ROS_CLOUDS_HPP
#define TERN_TESTS_PORTS_ROS_CLOUDS_HPP

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "tern/vec3.hpp"

namespace tern_test {

/// A wall across the room at x = 1 .. 1.2, with a gap beyond y = 4, as a cloud of points with an intensity, and one
/// point that is no measurement.
template <typename PointCloud2>
PointCloud2 cloud_of_wall() {
  PointCloud2 cloud;
  cloud.header.frame_id = "map";
  const char* names[] = {"x", "y", "z", "intensity"};
  cloud.fields.resize(4);
  for (unsigned i = 0; i < 4; ++i) {
    cloud.fields[i].name = names[i];
    cloud.fields[i].offset = 4 * i;
    cloud.fields[i].datatype = 7;
    cloud.fields[i].count = 1;
  }
  cloud.point_step = 16;
  cloud.height = 1;
  const auto add = [&cloud](float x, float y, float z) {
    const float point[4] = {x, y, z, 1.0f};
    const auto at = cloud.data.size();
    cloud.data.resize(at + sizeof point);
    std::memcpy(&cloud.data[at], point, sizeof point);
    ++cloud.width;
  };
  for (int k = 0; k < 3 * 140 * 40; ++k) {
    const int i = k / (140 * 40), j = k / 40 % 140, l = k % 40;
    add(1.05f + 0.1f * static_cast<float>(i), -9.95f + 0.1f * static_cast<float>(j),
        0.05f + 0.1f * static_cast<float>(l));
  }
  add(std::numeric_limits<float>::quiet_NaN(), 0.0f, 0.0f);
  cloud.row_step = cloud.point_step * cloud.width;
  return cloud;
}

/// Of a point from that wall, seen from above, m.
inline double distance_from_wall(const tern::Vec3& p) {
  const double x = std::max({1.0 - p.x, p.x - 1.3, 0.0}), y = std::max(p.y - 4.0, 0.0);
  return std::hypot(x, y);
}

}  // namespace tern_test

#endif
