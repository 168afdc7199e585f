// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_PORTS_ROS_CLOUDS_HPP
#define TERN_TESTS_PORTS_ROS_CLOUDS_HPP

#include <cmath>
#include <cstring>
#include <limits>

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

/// What is wrong with a trajectory message from (-3, 0, 1.5) to (4, 1, 1.5) past that wall; null if nothing is.
/// `seconds(point)` is its time from the start.
template <typename MultiDofTrajectory, typename Seconds>
const char* fault_of(const MultiDofTrajectory& trajectory, Seconds seconds) {
  const auto& points = trajectory.points;
  if (trajectory.header.frame_id != "map" || points.size() < 100) return "header or count";
  const auto near = [](const auto& v, double x, double y, double z) {
    return std::hypot(std::hypot(v.x - x, v.y - y), v.z - z) < 1e-9;
  };
  if (!near(points.front().transforms[0].translation, -3, 0, 1.5)) return "start";
  if (!near(points.back().transforms[0].translation, 4, 1, 1.5)) return "goal";
  if (!near(points.back().velocities[0].linear, 0, 0, 0)) return "end at rest";
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& p = points[i].transforms[0].translation;
    const auto& v = points[i].velocities[0].linear;
    if (std::abs(seconds(points[i]) - 0.02 * static_cast<double>(i)) > 1e-9) return "time";
    if (std::abs(v.x) > 2.0 + 1e-6 || std::abs(v.y) > 2.0 + 1e-6) return "limit of velocity";
    const double x = std::max({1.0 - p.x, p.x - 1.3, 0.0}), y = std::max(p.y - 4.0, 0.0);
    if (std::hypot(x, y) < 0.4 - 1e-6) return "too near to the wall";
    const auto& q = points[i].transforms[0].rotation;
    if (std::abs(q.w * q.w + q.z * q.z - 1.0) > 1e-12) return "rotation";
    if (i == 0) continue;
    const auto& before = points[i - 1];
    const double mean = 0.5 * (v.x + before.velocities[0].linear.x);
    if (std::abs((p.x - before.transforms[0].translation.x) / 0.02 - mean) > 1e-3) return "velocity is no derivative";
  }
  return nullptr;
}

}  // namespace tern_test

#endif
