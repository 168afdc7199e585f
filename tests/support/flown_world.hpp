// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A small world of upright cylinders and boxes on a floor, a depth camera in it, and a vehicle that follows commands.
// Nothing here is taken from the core: it is what the core's promises are held against.
#ifndef TERN_TESTS_SUPPORT_FLOWN_WORLD_HPP
#define TERN_TESTS_SUPPORT_FLOWN_WORLD_HPP

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "support/owned_map.hpp"
#include "support/random.hpp"
#include "tern/map.hpp"
#include "tern/vec3.hpp"

namespace tern_test {

struct Cylinder {
  double x, y, radius, top;
};

struct Scene {
  std::vector<Cylinder> cylinders;
  std::vector<tern::Box> boxes;

  /// Distance of a point from the nearest thing; with the floor at z = 0, unless that does not count.
  double clearance(const tern::Vec3& p, bool with_floor = true) const {
    double best = with_floor ? p.z : 1e9;
    for (const Cylinder& c : cylinders) {
      const double out = std::max(0.0, std::hypot(p.x - c.x, p.y - c.y) - c.radius);
      best = std::min(best, std::hypot(out, std::max(0.0, p.z - c.top)));
    }
    for (const tern::Box& b : boxes) {
      const double x = std::max({b.lower.x - p.x, p.x - b.upper.x, 0.0});
      const double y = std::max({b.lower.y - p.y, p.y - b.upper.y, 0.0});
      const double z = std::max({b.lower.z - p.z, p.z - b.upper.z, 0.0});
      best = std::min(best, std::sqrt(x * x + y * y + z * z));
    }
    return best;
  }

  /// The least t > 0 at which from + t * along meets something; `most` where nothing is nearer.
  double hit(const tern::Vec3& from, const tern::Vec3& along, double most) const {
    double best = along.z < 0.0 ? std::min(most, -from.z / along.z) : most;
    for (const Cylinder& c : cylinders) best = std::min(best, hit_cylinder(c, from, along, best));
    for (const tern::Box& b : boxes) best = std::min(best, hit_box(b, from, along, best));
    return best;
  }

 private:
  static double hit_cylinder(const Cylinder& c, const tern::Vec3& from, const tern::Vec3& along, double most) {
    const double x = from.x - c.x;
    const double y = from.y - c.y;
    const double square = along.x * along.x + along.y * along.y;
    const double mixed = x * along.x + y * along.y;
    const double rest = mixed * mixed - square * (x * x + y * y - c.radius * c.radius);
    if (rest <= 0.0) return most;
    const double t = (-mixed - std::sqrt(rest)) / square;
    if (t > 0.0 && t < most && from.z + t * along.z <= c.top) return t;
    const double down = along.z < 0.0 ? (c.top - from.z) / along.z : -1.0;  // the lid
    if (down > 0.0 && down < most && std::hypot(x + down * along.x, y + down * along.y) <= c.radius) return down;
    return most;
  }

  static double hit_box(const tern::Box& b, const tern::Vec3& from, const tern::Vec3& along, double most) {
    const double lower[3] = {b.lower.x - from.x, b.lower.y - from.y, b.lower.z - from.z};
    const double upper[3] = {b.upper.x - from.x, b.upper.y - from.y, b.upper.z - from.z};
    const double d[3] = {along.x, along.y, along.z};
    double enter = 0.0;
    double leave = most;
    for (int a = 0; a < 3; ++a) {
      if (d[a] == 0.0 && (lower[a] > 0.0 || upper[a] < 0.0)) return most;
      if (d[a] == 0.0) continue;
      enter = std::max(enter, std::min(lower[a] / d[a], upper[a] / d[a]));
      leave = std::min(leave, std::max(lower[a] / d[a], upper[a] / d[a]));
    }
    return enter < leave ? enter : most;
  }
};

/// A level depth camera of 90 by 74 degrees. A pixel has the least depth of its corners, so that it is free to that
/// depth all over, as the map demands of a sensor: no tree is narrower than a pixel. With `centers`, it has the depth
/// of its centre alone, and may show as free what is not.
class LevelCamera {
 public:
  LevelCamera() : image(160, 120, 80.0), corners(161 * 121) {}

  void render(const Scene& scene, const tern::Vec3& eye, double yaw) {
    const double c = std::cos(yaw);
    const double s = std::sin(yaw);
    const int width = image.view.width;
    const double corner = centers ? 0.0 : 0.5;
    for (int v = 0; v <= image.view.height; ++v) {
      for (int u = 0; u <= width; ++u) {
        const double right = (u - corner - image.view.cx) / image.view.fx;
        const double down = (v - corner - image.view.cy) / image.view.fy;
        const tern::Vec3 along{c + right * s, s - right * c, -down};
        corners[static_cast<std::size_t>(v * (width + 1) + u)] = static_cast<float>(scene.hit(eye, along, 30.0));
      }
    }
    for (int v = 0; v < image.view.height; ++v) {
      for (int u = 0; u < width; ++u) {
        const float* const top = &corners[static_cast<std::size_t>(v * (width + 1) + u)];
        image.at(u, v) =
            centers ? top[0] : std::min(std::min(top[0], top[1]), std::min(top[width + 1], top[width + 2]));
      }
    }
    const double w = std::cos(0.5 * yaw);
    const double z = std::sin(0.5 * yaw);
    // The turn by yaw after the turn from the camera's axes to ahead, left, up.
    pose = {eye, {0.5 * (w + z), 0.5 * (-w - z), 0.5 * (w - z), 0.5 * (z - w)}};
  }

  Image image;
  bool centers = false;
  std::vector<float> corners;
  tern::Pose pose{};
};

/// Trees on a strip along x, none near both ends.
inline Scene forest(Random& random, double length, double width, double density) {
  Scene scene;
  for (int k = static_cast<int>(density * length * width); k > 0; --k) {
    const Cylinder tree{random.real(0.0, length), random.real(-0.5 * width, 0.5 * width), random.real(0.2, 0.4), 6.0};
    if (std::hypot(tree.x, tree.y) > 2.0 && std::hypot(tree.x - length, tree.y) > 2.0) {
      scene.cylinders.push_back(tree);
    }
  }
  return scene;
}

}  // namespace tern_test

#endif
