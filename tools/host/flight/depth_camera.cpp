// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/depth_camera.hpp"

#include <algorithm>
#include <cmath>

#include "host/flight/speckle_filter.hpp"

namespace tern_host {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
/// Depth that a ray is followed to, in ranges.
constexpr double kFarther = 1.5;
/// Depth of an outlier at least, metres.
constexpr double kNearestOutlier = 0.1;

/// What an upright plane through the eye cuts out of a thing: two depths and two heights.
struct Slab {
  double enter, leave, bottom, top;
};

/// Where a line is between two planes: [enter, leave] cut down.
void cut(double from, double along, double lower, double upper, double& enter, double& leave) {
  if (along < 0.0 || along > 0.0) {
    const double a = (lower - from) / along;
    const double b = (upper - from) / along;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  } else if (from < lower || from > upper) {
    leave = enter;
  }
}

/// A camera's place, and how far it sees.
struct View {
  tern::Vec3 eye;
  double far;
};

void add_slab(const tern::Box& b, const View& view, double x, double y, std::vector<Slab>& slabs) {
  Slab slab{0.0, view.far, b.lower.z, b.upper.z};
  cut(view.eye.x, x, b.lower.x, b.upper.x, slab.enter, slab.leave);
  cut(view.eye.y, y, b.lower.y, b.upper.y, slab.enter, slab.leave);
  if (slab.enter < slab.leave) slabs.push_back(slab);
}

void add_slab(const Cylinder& c, const View& view, double x, double y, std::vector<Slab>& slabs) {
  const double from_x = view.eye.x - c.x;
  const double from_y = view.eye.y - c.y;
  const double square = x * x + y * y;
  const double mixed = from_x * x + from_y * y;
  const double rest = mixed * mixed - square * (from_x * from_x + from_y * from_y - c.radius * c.radius);
  if (rest <= 0.0) return;
  const double enter = std::max(0.0, (-mixed - std::sqrt(rest)) / square);
  const double leave = std::min(view.far, (-mixed + std::sqrt(rest)) / square);
  if (enter < leave) slabs.push_back({enter, leave, c.bottom, c.top});
}

/// Depth at which the ray that falls by `down` a metre meets a slab, or leaves the boundary.
double depth_in(const std::vector<Slab>& slabs, const Slab& room, double height, double down) {
  double best = room.leave;
  double enter = 0.0;
  cut(height, -down, room.bottom, room.top, enter, best);
  for (const Slab& slab : slabs) {
    if (slab.enter >= best) break;
    double from = slab.enter;
    double to = slab.leave;
    cut(height, -down, slab.bottom, slab.top, from, to);
    if (from < to) best = std::min(best, from);
  }
  return best;
}

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

/// Depths at the pixels' corners, (width + 1) x (height + 1). A level camera's columns are upright planes: each finds
/// once what it meets.
std::vector<float> corner_depths(const FlightWorld& world, const tern::DepthView& view, const View& from, double yaw) {
  const double wider = 0.5 + 0.5 / view.width;
  const double widest = std::hypot(1.0, wider * view.width / view.fx);
  const FlightWorld near = nearby(world, from.eye, from.far * widest);
  const int columns = view.width + 1;
  std::vector<float> depths(static_cast<std::size_t>(columns) * static_cast<std::size_t>(view.height + 1));
  std::vector<Slab> slabs;
  for (int u = 0; u < columns; ++u) {
    const double right = (u - 0.5 - view.cx) / view.fx;
    const double x = std::cos(yaw) + right * std::sin(yaw);
    const double y = std::sin(yaw) - right * std::cos(yaw);
    slabs.clear();
    add_slab(near.boundary, from, x, y, slabs);
    const Slab room = slabs.empty() ? Slab{0.0, 0.0, 0.0, 0.0} : slabs.front();
    slabs.clear();
    for (const tern::Box& block : near.blocks) add_slab(block, from, x, y, slabs);
    for (const Cylinder& cylinder : near.cylinders) add_slab(cylinder, from, x, y, slabs);
    std::sort(slabs.begin(), slabs.end(), [](const Slab& a, const Slab& b) { return a.enter < b.enter; });
    for (int v = 0; v <= view.height; ++v) {
      const double down = (v - 0.5 - view.cy) / view.fy;
      depths[static_cast<std::size_t>(v * columns + u)] = static_cast<float>(depth_in(slabs, room, from.eye.z, down));
    }
  }
  return depths;
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
  const std::vector<float> corners = corner_depths(world, frame.view, {eye, far}, yaw);
  std::size_t pixel = 0;
  for (int v = 0; v < s.height; ++v) {
    for (int u = 0; u < s.width; ++u, ++pixel) {
      const float* const top = &corners[static_cast<std::size_t>(v * (s.width + 1) + u)];
      double depth = static_cast<double>(std::min({top[0], top[1], top[s.width + 1], top[s.width + 2]}));
      if (s.depth_noise > 0.0) depth *= 1.0 + noise.within(-s.depth_noise, s.depth_noise);
      if (s.outliers > 0.0 && noise.chance(s.outliers)) depth = noise.within(kNearestOutlier, far);
      frame.depths[pixel] = static_cast<float>(depth);
    }
  }
  if (s.speckle_filter > 0) filter_speckle(frame.depths, s.width, s.height, s.depth_noise);
  return frame;
}

}  // namespace tern_host
