// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a rolling map is measured with: a forest on flat ground, a depth camera and a lidar in it. Only arithmetic and
// square roots, so that firmware sees the same pictures.
#ifndef TERN_BENCH_MAP_SCENE_HPP
#define TERN_BENCH_MAP_SCENE_HPP

#include <cstddef>
#include <cstdint>

#include "tern/map.hpp"

namespace tern_bench {

struct Tree {
  double x, y, radius;
};

/// Trees of radius 0.15 to 0.5 m, one on 25 square metres; the way along y = 0 is free.
class Forest {
 public:
  Forest() {
    while (count_ < kTrees) {
      const Tree tree{real(-10.0, 60.0), real(-28.0, 28.0), real(0.15, 0.5)};
      const double off = tree.y < 0.0 ? -tree.y : tree.y;
      if (off > tree.radius + 0.8) trees_[count_++] = tree;
    }
  }

  /// Moves the eye. Things beyond `far` of it are not looked at: the background is there.
  void look_from(const tern::Vec3& eye, double far) {
    eye_ = eye;
    far_ = far;
    near_count_ = 0;
    for (const Tree& tree : trees_) {
      const double x = eye.x - tree.x, y = eye.y - tree.y;
      if (x * x + y * y < (far + 1.0) * (far + 1.0)) near_[near_count_++] = tree;
    }
  }

  /// Distance along a ray, in lengths of the ray, to the nearest tree, the ground or the background. Something is
  /// behind it all: a sky without returns would leave nothing to do.
  double cast(const tern::Vec3& ray) const {
    double nearest = ray.z < 0.0 ? -eye_.z / ray.z : far_;
    if (nearest > far_) nearest = far_;
    const double a = ray.x * ray.x + ray.y * ray.y;
    for (int k = 0; k < near_count_; ++k) {
      const double x = eye_.x - near_[k].x, y = eye_.y - near_[k].y;
      const double b = x * ray.x + y * ray.y;
      const double d = b * b - a * (x * x + y * y - near_[k].radius * near_[k].radius);
      if (d <= 0.0 || b >= 0.0) continue;
      const double t = (-b - __builtin_sqrt(d)) / a;
      if (t > 0.0 && t < nearest) nearest = t;
    }
    return nearest;
  }

 private:
  static constexpr int kTrees = 160;

  double real(double low, double high) {
    random_ = random_ * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (static_cast<double>(random_ >> 40) / 16777216.0);
  }

  Tree trees_[kTrees];
  Tree near_[kTrees];
  int count_ = 0;
  int near_count_ = 0;
  std::uint64_t random_ = 11;
  tern::Vec3 eye_{};
  double far_ = 0.0;
};

/// A camera that looks along x of the world, 90 degrees wide. Numbers are millimetres.
constexpr double kAhead[4] = {0.5, -0.5, 0.5, -0.5};
inline tern::DepthView camera(const std::uint16_t* z, std::int32_t width, std::int32_t height) {
  return {z,     nullptr, width, height, width, 0.5 * width, 0.5 * width, 0.5 * (width - 1), 0.5 * (height - 1),
          0.001, 0.1,     59.0,  0.0};
}
inline tern::Pose looking_ahead(const tern::Vec3& eye) {
  return {eye, {kAhead[0], kAhead[1], kAhead[2], kAhead[3]}};
}

/// The camera's picture from where the forest is looked at.
inline void render(const Forest& forest, const tern::DepthView& view, std::uint16_t* z) {
  for (std::int32_t v = 0; v < view.height; ++v) {
    for (std::int32_t u = 0; u < view.width; ++u) {
      const double depth = 1000.0 * forest.cast({1.0, -(u - view.cx) / view.fx, -(v - view.cy) / view.fy});
      z[static_cast<std::size_t>(v) * static_cast<std::size_t>(view.width) + static_cast<std::size_t>(u)] =
          static_cast<std::uint16_t>(depth < 60000.0 ? depth : 60000.0);
    }
  }
}

/// A scan of 360 by 59 degrees, in a sequence that covers it evenly but for a factor of two.
inline void scan(const Forest& forest, const tern::Vec3& eye, std::size_t count, tern::Vec3* points) {
  double turn = 0.0;
  double tilt = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    turn += 0.7548776662466927;
    tilt += 0.5698402909980532;
    if (turn >= 1.0) turn -= 1.0;
    if (tilt >= 1.0) tilt -= 1.0;
    // A rational parameter of half the circle, then the other half.
    const double t = 4.0 * turn - (turn < 0.5 ? 1.0 : 3.0);
    const double scale = (turn < 0.5 ? 1.0 : -1.0) / (1.0 + t * t);
    const tern::Vec3 ray{(1.0 - t * t) * scale, 2.0 * t * scale, -0.1228 + 1.4027 * tilt};
    const double far = forest.cast(ray);
    points[k] = {eye.x + far * ray.x, eye.y + far * ray.y, eye.z + far * ray.z};
  }
}

/// A window, and what the vehicle's sensors are good for in it.
struct Window {
  const char* name;
  tern::Voxel dims;
  double cell, range;
};

inline tern::MapSpec spec_of(const Window& window, std::int32_t pixels, double scan_pixel) {
  const tern::Vec3 origin{-0.5 * window.dims.x * window.cell, -0.5 * window.dims.y * window.cell, 0.0};
  tern::MapSpec spec = tern::map_spec(origin, window.cell, window.dims, 0.3);
  spec.range = window.range;
  spec.pixels = pixels;
  spec.scan_pixel = scan_pixel;
  return spec;
}

}  // namespace tern_bench

#endif
