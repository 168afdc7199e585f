// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "autopilot/body_camera.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "tern_onboard/pose.hpp"

namespace tern_autopilot {
namespace {

using tern::Vec3;
constexpr double kNever = std::numeric_limits<double>::infinity();

/// Where a ray is between two planes at right angles to one axis; kept in [enter, leave].
void cut(double from, double along, double lower, double upper, double& enter, double& leave) {
  if (std::abs(along) < 1e-12) {
    if (from < lower || from > upper) enter = kNever;
    return;
  }
  const double a = (lower - from) / along;
  const double b = (upper - from) / along;
  enter = std::max(enter, std::min(a, b));
  leave = std::min(leave, std::max(a, b));
}

/// Of a ray from outside; kNever if it misses.
double depth_of(const tern::Box& box, const Vec3& from, const Vec3& along) {
  double enter = 0.0, leave = kNever;
  cut(from.x, along.x, box.lower.x, box.upper.x, enter, leave);
  cut(from.y, along.y, box.lower.y, box.upper.y, enter, leave);
  cut(from.z, along.z, box.lower.z, box.upper.z, enter, leave);
  return enter <= leave ? enter : kNever;
}

double depth_of(const tern_host::Cylinder& cylinder, const Vec3& from, const Vec3& along) {
  const double x = from.x - cylinder.x, y = from.y - cylinder.y;
  const double a = along.x * along.x + along.y * along.y;
  const double b = x * along.x + y * along.y;
  const double c = x * x + y * y - cylinder.radius * cylinder.radius;
  double enter = 0.0, leave = kNever;
  cut(from.z, along.z, cylinder.bottom, cylinder.top, enter, leave);
  if (a < 1e-12) return c <= 0.0 && enter <= leave ? enter : kNever;
  const double root = b * b - a * c;
  if (root < 0.0) return kNever;
  enter = std::max(enter, (-b - std::sqrt(root)) / a);
  leave = std::min(leave, (-b + std::sqrt(root)) / a);
  return enter <= leave ? enter : kNever;
}

/// Of the walls, from inside.
double depth_of_walls(const tern::Box& boundary, const Vec3& from, const Vec3& along) {
  double enter = 0.0, leave = kNever;
  cut(from.x, along.x, boundary.lower.x, boundary.upper.x, enter, leave);
  cut(from.y, along.y, boundary.lower.y, boundary.upper.y, enter, leave);
  cut(from.z, along.z, boundary.lower.z, boundary.upper.z, enter, leave);
  return std::max(leave, 0.0);
}

/// What is near enough to be seen.
struct Scene {
  const tern::Box* walls;
  std::vector<tern::Box> blocks;
  std::vector<tern_host::Cylinder> cylinders;

  Scene(const tern_host::FlightWorld& world, const Vec3& eye, double reach) : walls(&world.boundary) {
    const auto is_near = [&](const auto& thing) { return tern_host::distance_to(thing, eye) <= reach; };
    std::copy_if(world.blocks.begin(), world.blocks.end(), std::back_inserter(blocks), is_near);
    std::copy_if(world.cylinders.begin(), world.cylinders.end(), std::back_inserter(cylinders), is_near);
  }
  double depth(const Vec3& from, const Vec3& along) const {
    double least = depth_of_walls(*walls, from, along);
    for (const tern::Box& block : blocks) least = std::min(least, depth_of(block, from, along));
    for (const tern_host::Cylinder& cylinder : cylinders) least = std::min(least, depth_of(cylinder, from, along));
    return least;
  }
};

}  // namespace

CameraLens lens_of(const tern_host::FlightSettings& s) {
  return {s.width,
          s.height,
          0.5 * s.width / std::tan(0.5 * s.fov_horizontal),
          0.5 * s.height / std::tan(0.5 * s.fov_vertical),
          0.5 * (s.width - 1),
          0.5 * (s.height - 1)};
}

std::vector<float> take_image(const tern_host::FlightWorld& world, const tern::Pose& camera, const CameraLens& lens,
                              double far, tern_host::Noise& noise) {
  const double corner = std::hypot(1.0, std::hypot(lens.width / lens.fx, lens.height / lens.fy) / 2.0);
  const Scene scene(world, camera.position, far * corner);
  const auto columns = static_cast<std::size_t>(lens.width) + 1, rows = static_cast<std::size_t>(lens.height) + 1;
  std::vector<double> corners(columns * rows);
  for (std::size_t v = 0; v < rows; ++v) {
    for (std::size_t u = 0; u < columns; ++u) {
      const Vec3 ray{(static_cast<double>(u) - 0.5 - lens.cx) / lens.fx,
                     (static_cast<double>(v) - 0.5 - lens.cy) / lens.fy, 1.0};
      corners[v * columns + u] =
          std::min(far, scene.depth(camera.position, tern_onboard::turn(camera.quaternion, ray)));
    }
  }
  std::vector<float> depths;
  for (std::size_t v = 0; v + 1 < rows; ++v) {
    for (std::size_t u = 0; u + 1 < columns; ++u) {
      const double* const at = &corners[v * columns + u];
      double depth = std::min(std::min(at[0], at[1]), std::min(at[columns], at[columns + 1]));
      const double error = world.settings.depth_noise;
      if (error > 0.0) depth *= 1.0 + noise.within(-error, error);
      depths.push_back(static_cast<float>(depth));
    }
  }
  return depths;
}

}  // namespace tern_autopilot
