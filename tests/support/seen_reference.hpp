// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Free means seen: each voxel that a frame shows was, with its whole cube, in front of every pixel that covers it. Here
// that is found out from the cube's eight corners, in long double, pixel by pixel.
#ifndef TERN_TESTS_SUPPORT_SEEN_REFERENCE_HPP
#define TERN_TESTS_SUPPORT_SEEN_REFERENCE_HPP

#include <algorithm>
#include <cmath>

#include "support/grid_storage.hpp"
#include "support/owned_map.hpp"

namespace tern_test {

using tern::MapSpec;
using tern::Pose;
using tern::Status;
using tern::Vec3;
using tern::Voxel;

using Real = long double;

/// A point in the middle part of the window.
inline Vec3 inside_window(Random& random, const MapSpec& spec) {
  const auto on = [&](double origin, int count) { return origin + count * spec.cell * random.real(0.3, 0.7); };
  return {on(spec.origin.x, spec.dims.x), on(spec.origin.y, spec.dims.y), on(spec.origin.z, spec.dims.z)};
}

/// A cube in the camera's frame and in the image.
struct Seen {
  Real deepest = -1e30L, nearest = 1e30L;
  Real u0 = 1e30L, u1 = -1e30L, v0 = 1e30L, v1 = -1e30L;
};

/// Corners of the cube, turned into the camera's frame by the quaternion's conjugate.
inline Seen look(const MapSpec& spec, const Image& image, const Pose& pose, const Voxel& voxel) {
  const Real w = pose.quaternion[0], x = pose.quaternion[1], y = pose.quaternion[2], z = pose.quaternion[3];
  const Real rotation[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                               {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                               {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
  Seen seen;
  for (int corner = 0; corner < 8; ++corner) {
    const Real p[3] = {spec.origin.x + (voxel.x + (corner & 1)) * Real{spec.cell} - pose.position.x,
                       spec.origin.y + (voxel.y + (corner >> 1 & 1)) * Real{spec.cell} - pose.position.y,
                       spec.origin.z + (voxel.z + (corner >> 2)) * Real{spec.cell} - pose.position.z};
    Real c[3];
    for (int a = 0; a < 3; ++a) c[a] = rotation[0][a] * p[0] + rotation[1][a] * p[1] + rotation[2][a] * p[2];
    seen.deepest = std::max(seen.deepest, c[2]);
    seen.nearest = std::min(seen.nearest, c[2]);
    const Real u = image.view.fx * c[0] / c[2] + image.view.cx, v = image.view.fy * c[1] / c[2] + image.view.cy;
    seen.u0 = std::min(seen.u0, u), seen.u1 = std::max(seen.u1, u);
    seen.v0 = std::min(seen.v0, v), seen.v1 = std::max(seen.v1, v);
  }
  return seen;
}

/// The least depth that the pixels covering a rectangle are free up to; below 0 where one says nothing or is missing.
inline Real free_depth(const MapSpec& spec, Image& image, const Seen& seen) {
  constexpr Real kTie = 1e-9L;  // a pixel that the cube touches by less does not cover it
  const int u0 = static_cast<int>(std::floor(seen.u0 + 0.5L + kTie)),
            u1 = static_cast<int>(std::floor(seen.u1 + 0.5L - kTie));
  const int v0 = static_cast<int>(std::floor(seen.v0 + 0.5L + kTie)),
            v1 = static_cast<int>(std::floor(seen.v1 + 0.5L - kTie));
  if (u0 < 0 || v0 < 0 || u1 >= image.view.width || v1 >= image.view.height) return -1;
  Real least = spec.range;
  for (int v = v0; v <= v1; ++v) {
    for (int u = u0; u <= u1; ++u) {
      const Real z = image.at(u, v);
      if (image.view.no_return > 0 && (z == 0 || z == Real{INFINITY})) {
        least = std::min(least, Real{image.view.no_return});
        continue;
      }
      if (!(z > 0) || !(z >= image.view.min) || !(z < image.view.max)) return -1;
      least = std::min(least, z - (spec.depth_margin + spec.depth_margin_square * z * z));
    }
  }
  return least;
}

/// Sums over frames or scans.
struct SeenCounts {
  long long frames = 0;
  long long shown = 0;     ///< voxels that the map calls seen
  long long could_be = 0;  ///< voxels that were seen whole
  long long hits = 0;      ///< points that must block a voxel
  long long wrong = 0;     ///< shown, but not seen whole
  long long missed = 0;    ///< hit, but not blocked in both grids
  long long refused = 0;

  void add(const SeenCounts& c) {
    frames += c.frames, shown += c.shown, could_be += c.could_be, hits += c.hits;
    wrong += c.wrong, missed += c.missed, refused += c.refused;
  }
};

/// A point at a voxel blocks it in both grids; a voxel outside the window does not count.
inline void count_hit(const tern::RollingMap& map, const Voxel& voxel, SeenCounts& counts) {
  if (!map.route().inside(voxel)) return;
  ++counts.hits;
  counts.missed += map.route().obstacle(voxel) && map.safe().obstacle(voxel) ? 0 : 1;
}

/// A pose that is off by as much as the margins allow: what the map is told, where the camera is at `pose`.
inline Pose wrong_pose(Random& random, const MapSpec& spec, const Pose& pose) {
  double q[4];
  random_quaternion(random, q);
  const double length = std::sqrt(q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  const double sine = std::sin(0.5 * spec.angle_margin) / length;
  const double e[4] = {std::cos(0.5 * spec.angle_margin), sine * q[1], sine * q[2], sine * q[3]};
  const double* p = pose.quaternion;
  Pose wrong{
      pose.position,
      {p[0] * e[0] - p[1] * e[1] - p[2] * e[2] - p[3] * e[3], p[0] * e[1] + p[1] * e[0] + p[2] * e[3] - p[3] * e[2],
       p[0] * e[2] - p[1] * e[3] + p[2] * e[0] + p[3] * e[1], p[0] * e[3] + p[1] * e[2] - p[2] * e[1] + p[3] * e[0]}};
  wrong.position.x += q[1] / length * spec.pose_margin;
  wrong.position.y += q[2] / length * spec.pose_margin;
  wrong.position.z += q[3] / length * spec.pose_margin;
  return wrong;
}

/// The voxel of a pixel's point, as the map is told the pose; outside the window where the point is too near to a face
/// of its voxel to tell, or hits nothing.
inline Voxel hit_voxel(const MapSpec& spec, Image& image, const Pose& told, int u, int v) {
  const Voxel none{-1, -1, -1};
  const Real z = image.at(u, v);
  if (!(z > 0) || !(z >= image.view.min) || !(z < image.view.max) || z > spec.range) return none;
  const Real c[3] = {(u - Real{image.view.cx}) / image.view.fx * z, (v - Real{image.view.cy}) / image.view.fy * z, z};
  const Real q0 = told.quaternion[0], x = told.quaternion[1], y = told.quaternion[2], w = told.quaternion[3];
  const Real p[3] = {(1 - 2 * (y * y + w * w)) * c[0] + 2 * (x * y - q0 * w) * c[1] + 2 * (x * w + q0 * y) * c[2],
                     2 * (x * y + q0 * w) * c[0] + (1 - 2 * (x * x + w * w)) * c[1] + 2 * (y * w - q0 * x) * c[2],
                     2 * (x * w - q0 * y) * c[0] + 2 * (y * w + q0 * x) * c[1] + (1 - 2 * (x * x + y * y)) * c[2]};
  const Real cells[3] = {(told.position.x - spec.origin.x + p[0]) / spec.cell,
                         (told.position.y - spec.origin.y + p[1]) / spec.cell,
                         (told.position.z - spec.origin.z + p[2]) / spec.cell};
  for (const Real at : cells) {
    if (std::abs(at - std::round(at)) < 1e-3L) return none;
  }
  const auto whole = [](Real at) { return static_cast<int>(std::floor(at)); };
  return {whole(cells[0]), whole(cells[1]), whole(cells[2])};
}

/// Enters one random frame into a new map, and looks at each pixel and each voxel.
inline SeenCounts check_frame(Random& random, const MapSpec& spec) {
  OwnedMap owned(spec);
  Image image(random.integer(8, 40), random.integer(8, 40), random.real(5.0, 40.0));
  image.view.fy *= random.real(0.8, 1.2);
  image.view.cx += random.real(-3.0, 3.0);
  fill_randomly(random, image, spec.range);
  if (random.chance(0.5)) image.view.no_return = random.real(0.1, 1.5 * spec.range);
  Pose pose{inside_window(random, spec), {}};
  random_quaternion(random, pose.quaternion);
  const Pose told = wrong_pose(random, spec, pose);
  SeenCounts counts;
  counts.frames = 1;
  const bool entered =
      owned.map.begin_frame(image.view, told, 0) == Status::kRunning && finish(owned.map) == Status::kOk;
  counts.refused = entered ? 0 : 1;
  for (int v = 0; v < image.view.height && entered; ++v) {
    for (int u = 0; u < image.view.width; ++u) count_hit(owned.map, hit_voxel(spec, image, told, u, v), counts);
  }
  for_each_voxel(spec.dims, [&](const Voxel& voxel) {
    const Seen seen = look(spec, image, pose, voxel);
    const bool whole = seen.nearest > 0 && free_depth(spec, image, seen) >= seen.deepest;
    const bool shown = owned.map.seen(voxel);
    counts.shown += shown ? 1 : 0;
    counts.could_be += whole ? 1 : 0;
    counts.wrong += shown && !whole ? 1 : 0;
  });
  return counts;
}

/// A small window, and margins of which half are 0.
inline MapSpec random_spec(Random& random) {
  const Voxel dims{random.integer(8, 90), random.integer(4, 16), random.integer(4, 16)};
  MapSpec spec = tern::map_spec({random.real(-5.0, 5.0), 1.0, -2.0}, random.real(0.05, 0.3), dims, 0.2);
  spec.range = random.real(1.0, 6.0);
  spec.depth_margin = random.chance(0.5) ? 0.0 : 0.05;
  spec.depth_margin_square = random.chance(0.5) ? 0.0 : 0.01;
  const bool exact = random.chance(0.5);
  spec.pose_margin = exact ? 0.0 : random.real(0.0, 0.2 * spec.cell);
  spec.angle_margin = exact ? 0.0 : random.real(0.0, 0.03);
  spec.pixels = 4096;
  return spec;
}

}  // namespace tern_test

#endif
