// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/depth_camera.hpp"

#include <algorithm>
#include <cmath>

namespace tern_host {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
/// Depth that a ray is followed to, in ranges.
constexpr double kFarther = 1.5;

/// What is near enough to be seen: most of a world is not.
FlightWorld nearby(const FlightWorld& world, const tern::Vec3& eye, double reach) {
  FlightWorld near;
  near.boundary = world.boundary;
  for (const tern::Box& b : world.blocks) {
    const double x = std::max({b.lower.x - eye.x, eye.x - b.upper.x, 0.0});
    const double y = std::max({b.lower.y - eye.y, eye.y - b.upper.y, 0.0});
    if (std::hypot(x, y) < reach) near.blocks.push_back(b);
  }
  for (const Cylinder& c : world.cylinders) {
    if (std::hypot(c.x - eye.x, c.y - eye.y) < reach + c.radius) near.cylinders.push_back(c);
  }
  return near;
}

tern::DepthView view_of(const FlightSettings& s, const float* depths) {
  tern::DepthView view{};
  view.z32 = depths;
  view.width = view.stride = s.width;
  view.height = s.height;
  view.fx = 0.5 * s.width / std::tan(0.5 * s.fov_horizontal * kDegree);
  view.fy = 0.5 * s.height / std::tan(0.5 * s.fov_vertical * kDegree);
  view.cx = 0.5 * (s.width - 1);
  view.cy = 0.5 * (s.height - 1);
  view.scale = 1.0;
  view.min = 0.1;
  view.max = 1000.0;
  return view;
}

/// From the camera's axes (right, down, ahead) to the world's.
tern::Pose pose_of(const tern::Vec3& eye, double yaw) {
  const double w = std::cos(0.5 * yaw);
  const double z = std::sin(0.5 * yaw);
  return {eye, {0.5 * (w + z), -0.5 * (w + z), 0.5 * (w - z), 0.5 * (z - w)}};
}

}  // namespace

DepthFrame take_frame(const FlightWorld& world, const tern::Vec3& eye, double yaw, std::int64_t t, Noise& noise) {
  const FlightSettings& s = world.settings;
  DepthFrame frame;
  frame.depths.resize(static_cast<std::size_t>(s.width) * static_cast<std::size_t>(s.height));
  frame.view = view_of(s, frame.depths.data());
  frame.pose = pose_of(eye, yaw);
  frame.taken = t;
  const double far = kFarther * s.sensor_range;
  const double widest = std::hypot(1.0, std::hypot(0.5 * s.width / frame.view.fx, 0.5 * s.height / frame.view.fy));
  const FlightWorld near = nearby(world, eye, far * widest);
  std::size_t pixel = 0;
  for (int v = 0; v < s.height; ++v) {
    for (int u = 0; u < s.width; ++u, ++pixel) {
      const double right = (u - frame.view.cx) / frame.view.fx;
      const double down = (v - frame.view.cy) / frame.view.fy;
      const tern::Vec3 along{std::cos(yaw) + right * std::sin(yaw), std::sin(yaw) - right * std::cos(yaw), -down};
      double depth = first_hit(near, eye, along, far);
      if (s.depth_noise > 0.0) depth *= 1.0 + noise.within(-s.depth_noise, s.depth_noise);
      if (s.outliers > 0.0 && noise.chance(s.outliers)) depth = noise.within(0.1, far);
      frame.depths[pixel] = static_cast<float>(depth);
    }
  }
  return frame;
}

}  // namespace tern_host
