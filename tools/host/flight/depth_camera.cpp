// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/depth_camera.hpp"

#include <cmath>
#include <limits>

#include "host/flight/face_image.hpp"
#include "host/flight/pixel_columns.hpp"
#include "host/flight/speckle_filter.hpp"
#include "host/yaw/yaw_units.hpp"

namespace tern_host {
namespace {

/// The borders between pixels, from the first one's to the last one's, in metres aside for each metre ahead.
std::vector<double> borders(int pixels, double center, double focal) {
  std::vector<double> at;
  for (int k = 0; k <= pixels; ++k) at.push_back((k - 0.5 - center) / focal);
  return at;
}

/// What a pixel measures where `depth` is.
double measured(double depth, const FlightSettings& s, Noise& noise) {
  if (s.depth_noise > 0.0) depth *= 1.0 + noise.within(-s.depth_noise, s.depth_noise);
  if (s.depth_error.at(depth) > 0.0) depth += noise.within(-s.depth_error.at(depth), s.depth_error.at(depth));
  if (s.outliers > 0.0 && noise.chance(s.outliers)) depth = noise.within(kNearestOutlier, kFarther * s.sensor_range);
  return depth;
}

/// The largest error of the farthest depth, metres a metre.
double relative_error(const FlightSettings& s) {
  return s.depth_noise + s.depth_error.at(s.sensor_range) / s.sensor_range;
}

/// Round patches that look as if nothing came back, as a stereo camera has them where it finds nothing to compare.
void punch_holes(const FlightSettings& s, Noise& noise, std::vector<float>& depths) {
  constexpr double kRadius = 0.03;  // of the image's width
  const double radius = kRadius * s.width;
  const int count = static_cast<int>(std::lround(s.holes * s.width * s.height / (0.5 * kTurn * radius * radius)));
  for (int k = 0; k < count; ++k) {
    const double at_u = noise.within(0.0, s.width);
    const double at_v = noise.within(0.0, s.height);
    for (int v = 0; v < s.height; ++v) {
      for (int u = 0; u < s.width; ++u) {
        if (std::hypot(u - at_u, v - at_v) < radius) depths[static_cast<std::size_t>(v * s.width + u)] = 0.0f;
      }
    }
  }
}

/// An image with a depth for each pixel, row by row, and the camera's errors.
template <typename DepthOf>
DepthFrame frame_of(const FlightSettings& s, const tern::Pose& camera, std::int64_t t, Noise& noise, DepthOf depth_of) {
  DepthFrame frame;
  frame.depths.resize(static_cast<std::size_t>(s.width) * static_cast<std::size_t>(s.height));
  frame.view = lens_of(s);
  frame.view.z32 = frame.depths.data();
  frame.pose = camera;
  frame.taken = t;
  std::size_t pixel = 0;
  for (int v = 0; v < s.height; ++v) {
    for (int u = 0; u < s.width; ++u, ++pixel) {
      frame.depths[pixel] = static_cast<float>(measured(depth_of(u, v), s, noise));
    }
  }
  if (s.speckle_filter > 0) filter_speckle(frame.depths, s.width, s.height, relative_error(s));
  // Zero is for what nothing came back to; where the filter found no depth, nothing is known.
  for (float& depth : frame.depths) {
    if (!(depth > 0.0f)) depth = std::numeric_limits<float>::quiet_NaN();
    if (s.sensor_far > 0.0 && static_cast<double>(depth) > s.sensor_far) depth = 0.0f;
  }
  if (s.holes > 0.0) punch_holes(s, noise, frame.depths);
  return frame;
}

}  // namespace

tern::DepthView lens_of(const FlightSettings& s) {
  tern::DepthView view{};
  view.width = view.stride = s.width;
  view.height = s.height;
  view.fx = 0.5 * s.width / std::tan(0.5 * s.fov_horizontal);
  view.fy = 0.5 * s.height / std::tan(0.5 * s.fov_vertical);
  view.cx = 0.5 * (s.width - 1);
  view.cy = 0.5 * (s.height - 1);
  view.scale = 1.0;
  view.min = s.sensor_min;
  view.max = 1000.0;
  view.no_return = s.no_return;
  return view;
}

DepthFrame take_frame(const FlightWorld& world, const tern::Vec3& eye, double yaw, std::int64_t t, Noise& noise) {
  const FlightSettings& s = world.settings;
  const tern::DepthView view = lens_of(s);
  const PixelColumns columns(world, eye, yaw, kFarther * s.sensor_range, borders(s.width, view.cx, view.fx));
  const std::vector<double> downs = borders(s.height, view.cy, view.fy);
  return frame_of(s, camera_pose({}, eye, level_attitude(yaw), 0.0), t, noise, [&](int u, int v) {
    const auto row = static_cast<std::size_t>(v);
    return columns.depth(u, downs[row], downs[row + 1]);
  });
}

DepthFrame take_frame(const FlightWorld& world, const tern::Pose& camera, std::int64_t t, Noise& noise) {
  const FlightSettings& s = world.settings;
  const double far = kFarther * s.sensor_range;
  const std::vector<double> depths = depths_of_faces(world, camera, lens_of(s), far, s.pixel_part);
  return frame_of(s, camera, t, noise, [&](int u, int v) { return depths[static_cast<std::size_t>(v * s.width + u)]; });
}

}  // namespace tern_host
