// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/depth_camera.hpp"

#include <cmath>

#include "host/flight/pixel_columns.hpp"
#include "host/flight/speckle_filter.hpp"

namespace tern_host {
namespace {

tern::DepthView view_of(const FlightSettings& s, const float* depths) {
  tern::DepthView view{};
  view.z32 = depths;
  view.width = view.stride = s.width;
  view.height = s.height;
  view.fx = 0.5 * s.width / std::tan(0.5 * s.fov_horizontal);
  view.fy = 0.5 * s.height / std::tan(0.5 * s.fov_vertical);
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

/// The borders between pixels, from the first one's to the last one's, in metres aside for each metre ahead.
std::vector<double> borders(int pixels, double center, double focal) {
  std::vector<double> at;
  for (int k = 0; k <= pixels; ++k) at.push_back((k - 0.5 - center) / focal);
  return at;
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
  const tern::DepthView& view = frame.view;
  const PixelColumns columns(world, eye, yaw, far, borders(s.width, view.cx, view.fx));
  const std::vector<double> downs = borders(s.height, view.cy, view.fy);
  std::size_t pixel = 0;
  for (int v = 0; v < s.height; ++v) {
    for (int u = 0; u < s.width; ++u, ++pixel) {
      const auto row = static_cast<std::size_t>(v);
      double depth = columns.depth(u, downs[row], downs[row + 1]);
      if (s.depth_noise > 0.0) depth *= 1.0 + noise.within(-s.depth_noise, s.depth_noise);
      if (s.outliers > 0.0 && noise.chance(s.outliers)) depth = noise.within(kNearestOutlier, far);
      frame.depths[pixel] = static_cast<float>(depth);
    }
  }
  if (s.speckle_filter > 0) filter_speckle(frame.depths, s.width, s.height, s.depth_noise);
  return frame;
}

}  // namespace tern_host
