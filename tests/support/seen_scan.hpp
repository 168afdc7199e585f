// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Free means seen, for scans: each voxel that a scan shows lies, as a whole, in one of the six faces around the sensor,
// every pixel of the face that it touches has a beam, and all these beams are free beyond it.
#ifndef TERN_TESTS_SUPPORT_SEEN_SCAN_HPP
#define TERN_TESTS_SUPPORT_SEEN_SCAN_HPP

#include <array>
#include <vector>

#include "support/seen_reference.hpp"

namespace tern_test {

/// Pixels by which a beam or an outline may miss the edge of a pixel: single precision puts them on either side.
constexpr Real kEdge = 1e-4L;

using RealPoint = std::array<Real, 3>;

/// What the beams of one pixel say.
struct BeamPixel {
  bool any = false;               ///< a beam goes through it, or along its edge
  bool sure = false;              ///< a beam goes through it
  Real least = 1e30L;             ///< depth up to which all beams that surely go through it are free
  Real least_with_edges = 1e30L;  ///< and those along its edge
};

/// The beams of a scan on one face. Pixels are told by their numbers along the two axes after the face's own.
class BeamFace {
 public:
  BeamFace(int axis, int sign, int count)
      : axis_(axis), sign_(sign), count_(count), pixels_(static_cast<std::size_t>(count * count)) {}

  void add(const RealPoint& ray, Real free_part) {
    const Real ahead = sign_ * ray[static_cast<std::size_t>(axis_)];
    if (!(ahead > 0)) return;
    const Real u = pixel(ray, 1, ahead), v = pixel(ray, 2, ahead);
    for (int b = -1; b <= 1; ++b) {
      for (int a = -1; a <= 1; ++a) {
        const int at_u = static_cast<int>(std::floor(u + a * kEdge)),
                  at_v = static_cast<int>(std::floor(v + b * kEdge));
        if (at_u < 0 || at_v < 0 || at_u >= count_ || at_v >= count_) continue;
        BeamPixel& p = pixels_[static_cast<std::size_t>(at_v * count_ + at_u)];
        p.any = true;
        p.least_with_edges = std::min(p.least_with_edges, ahead * free_part);
        const bool sure =
            std::floor(u - kEdge) == std::floor(u + kEdge) && std::floor(v - kEdge) == std::floor(v + kEdge);
        if (!sure) continue;
        p.sure = true;
        p.least = std::min(p.least, ahead * free_part);
      }
    }
  }

  /// True if the cube is seen whole in this face. Where edges decide, `strict` says no, else yes.
  bool sees(const std::array<RealPoint, 8>& corners, bool strict) const {
    Real u0 = 1e30L, u1 = -1e30L, v0 = 1e30L, v1 = -1e30L, deepest = 0;
    for (const RealPoint& corner : corners) {
      const Real ahead = sign_ * corner[static_cast<std::size_t>(axis_)];
      if (!(ahead > 0)) return false;
      const Real u = pixel(corner, 1, ahead), v = pixel(corner, 2, ahead);
      u0 = std::min(u0, u), u1 = std::max(u1, u), v0 = std::min(v0, v), v1 = std::max(v1, v);
      deepest = std::max(deepest, ahead);
    }
    const Real edge = strict ? -kEdge : kEdge;
    const int first_u = static_cast<int>(std::floor(u0 + edge)), last_u = static_cast<int>(std::floor(u1 - edge));
    const int first_v = static_cast<int>(std::floor(v0 + edge)), last_v = static_cast<int>(std::floor(v1 - edge));
    if (first_u < 0 || first_v < 0 || last_u >= count_ || last_v >= count_) return false;
    for (int v = first_v; v <= last_v; ++v) {
      for (int u = first_u; u <= last_u; ++u) {
        const BeamPixel& p = pixels_[static_cast<std::size_t>(v * count_ + u)];
        if (!(strict ? p.sure : p.any) || (strict ? p.least_with_edges : p.least) < deepest) return false;
      }
    }
    return true;
  }

 private:
  /// In pixels from the face's edge; faces are 1.25 times as wide as those of a cube.
  Real pixel(const RealPoint& p, int next, Real ahead) const {
    return (p[static_cast<std::size_t>((axis_ + next) % 3)] / ahead / 1.25L + 1) / 2 * count_;
  }

  int axis_, sign_, count_;
  std::vector<BeamPixel> pixels_;
};

/// A room with pillars: distance along a direction.
struct Room {
  Vec3 lower, upper;
  Vec3 balls[4];
  double radii[4];

  explicit Room(Random& random, double range) {
    const auto far = [&] { return random.real(0.2, 1.6) * range; };
    lower = {-far(), -far(), -far()};
    upper = {far(), far(), far()};
    for (int k = 0; k < 4; ++k) {
      balls[k] = {random.real(-1, 1) * range, random.real(-1, 1) * range, random.real(-1, 1) * range};
      radii[k] = random.real(0.02, 0.3) * range;
    }
  }
  double cast(const Vec3& unit) const {
    double nearest = 1e9;
    const double d[] = {unit.x, unit.y, unit.z}, lo[] = {lower.x, lower.y, lower.z}, up[] = {upper.x, upper.y, upper.z};
    for (int a = 0; a < 3; ++a) {
      if (d[a] != 0.0) nearest = std::min(nearest, (d[a] < 0.0 ? lo[a] : up[a]) / d[a]);
    }
    for (int k = 0; k < 4; ++k) {
      const Vec3& c = balls[k];
      const double b = c.x * unit.x + c.y * unit.y + c.z * unit.z;
      const double off = c.x * c.x + c.y * c.y + c.z * c.z - b * b, square = radii[k] * radii[k] - off;
      if (square > 0.0 && b > std::sqrt(square)) nearest = std::min(nearest, b - std::sqrt(square));
    }
    return nearest;
  }
};

/// Vectors to the points of a scan: some beams for every pixel, a few pixels without, outliers, points that are none.
inline std::vector<Vec3> random_rays(Random& random, const MapSpec& spec, int count) {
  const Room room(random, spec.range);
  const int beams = random.integer(1, 3);
  const double dropped = random.chance(0.5) ? 0.0 : 0.02, outliers = random.chance(0.5) ? 0.0 : 0.01;
  std::vector<Vec3> rays;
  for (int k = 0; k < 6 * count * count * beams; ++k) {
    const int face = k / beams % 6, u = k / beams / 6 % count, v = k / beams / 6 / count;
    if (random.chance(dropped)) continue;
    double d[3];
    d[face / 2] = face % 2 == 0 ? 1.0 : -1.0;
    d[(face / 2 + 1) % 3] = ((u + random.unit()) / count - 0.5) * 2.5;
    d[(face / 2 + 2) % 3] = ((v + random.unit()) / count - 0.5) * 2.5;
    const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    const Vec3 unit{d[0] / length, d[1] / length, d[2] / length};
    double far = room.cast(unit);
    if (random.chance(outliers)) {
      const double odd[] = {NAN, INFINITY, 1e300, 0.0, random.real(0.01, 1.0) * spec.range};
      far = odd[random.integer(0, 4)];
    }
    rays.push_back({far * unit.x, far * unit.y, far * unit.z});
  }
  return rays;
}

/// Rotates by a quaternion.
inline RealPoint rotated(const double (&q)[4], const RealPoint& p) {
  const Real w = q[0], x = q[1], y = q[2], z = q[3];
  return {(1 - 2 * (y * y + z * z)) * p[0] + 2 * (x * y - w * z) * p[1] + 2 * (x * z + w * y) * p[2],
          2 * (x * y + w * z) * p[0] + (1 - 2 * (x * x + z * z)) * p[1] + 2 * (y * z - w * x) * p[2],
          2 * (x * z - w * y) * p[0] + 2 * (y * z + w * x) * p[1] + (1 - 2 * (x * x + y * y)) * p[2]};
}

/// The vector as the map is told it, from the point and the origin that it is given. False if the point is skipped.
inline bool told_ray(const Vec3& point, const Vec3& origin, RealPoint& ray) {
  ray = {Real{point.x} - origin.x, Real{point.y} - origin.y, Real{point.z} - origin.z};
  return std::abs(ray[0]) < 1e18L && std::abs(ray[1]) < 1e18L && std::abs(ray[2]) < 1e18L;
}

/// The voxel of a point that is within the range; outside the window where it is too near to a face of its voxel or to
/// the end of the range to tell.
inline Voxel scanned_voxel(const MapSpec& spec, const RealPoint& ray, const Vec3& origin) {
  const Real far = std::sqrt(ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2]);
  if (far > spec.range * (1 - 1e-5L) || far < 1e-6L) return {-1, -1, -1};
  const Real from[] = {Real{origin.x} - spec.origin.x, Real{origin.y} - spec.origin.y, Real{origin.z} - spec.origin.z};
  int voxel[3];
  for (std::size_t a = 0; a < 3; ++a) {
    const Real cells = (from[a] + ray[a]) / spec.cell;
    if (std::abs(cells - std::round(cells)) < 1e-3L) return {-1, -1, -1};
    voxel[a] = static_cast<int>(std::floor(cells));
  }
  return {voxel[0], voxel[1], voxel[2]};
}

/// The corners of a voxel as the sensor sees them: the true place, in the axes that the map is told.
inline std::array<RealPoint, 8> corners_of(const MapSpec& spec, const Voxel& v, const Vec3& eye,
                                           const double (&turn)[4]) {
  std::array<RealPoint, 8> corners;
  for (int k = 0; k < 8; ++k) {
    const RealPoint p{spec.origin.x + (v.x + (k & 1)) * Real{spec.cell} - eye.x,
                      spec.origin.y + (v.y + (k >> 1 & 1)) * Real{spec.cell} - eye.y,
                      spec.origin.z + (v.z + (k >> 2)) * Real{spec.cell} - eye.z};
    corners[static_cast<std::size_t>(k)] = rotated(turn, p);
  }
  return corners;
}

inline MapSpec random_scan_spec(Random& random) {
  MapSpec spec = random_spec(random);
  spec.scan_pixel = random.real(0.1, 0.3);
  spec.range = random.real(0.5, 3.0);
  return spec;
}

/// Enters one random scan into a new map, and looks at each point and each voxel. The map is told an origin and axes
/// that are wrong by as much as its margins allow.
inline SeenCounts check_scan(Random& random, const MapSpec& spec) {
  const int count = static_cast<int>(2.5 / spec.scan_pixel);
  const Vec3 eye = inside_window(random, spec);
  const Pose told = wrong_pose(random, spec, {eye, {1.0, 0.0, 0.0, 0.0}});
  std::vector<BeamFace> faces;
  for (int f = 0; f < 6; ++f) faces.emplace_back(f / 2, f % 2 == 0 ? 1 : -1, count);
  std::vector<Vec3> points = random_rays(random, spec, count);
  for (Vec3& point : points) {
    const RealPoint ray = rotated(told.quaternion, {point.x, point.y, point.z});
    point = {static_cast<double>(told.position.x + ray[0]), static_cast<double>(told.position.y + ray[1]),
             static_cast<double>(told.position.z + ray[2])};
  }
  OwnedMap owned(spec);
  SeenCounts counts;
  counts.frames = 1;
  const bool entered = owned.map.begin_scan(points.data(), points.size(), told.position, 0) == Status::kRunning &&
                       finish(owned.map) == Status::kOk;
  counts.refused = entered ? 0 : 1;
  for (const Vec3& point : points) {
    RealPoint ray;
    if (!entered || !told_ray(point, told.position, ray)) continue;
    const Real far = std::sqrt(ray[0] * ray[0] + ray[1] * ray[1] + ray[2] * ray[2]);
    const Real free = std::min(Real{spec.range}, far - (spec.depth_margin + spec.depth_margin_square * far * far));
    for (BeamFace& face : faces) face.add(ray, free / far);
    count_hit(owned.map, scanned_voxel(spec, ray, told.position), counts);
  }
  for_each_voxel(spec.dims, [&](const Voxel& voxel) {
    const std::array<RealPoint, 8> corners = corners_of(spec, voxel, eye, told.quaternion);
    const auto any = [&](bool strict) {
      return std::any_of(faces.begin(), faces.end(), [&](const BeamFace& face) { return face.sees(corners, strict); });
    };
    const bool shown = owned.map.seen(voxel);
    counts.shown += shown ? 1 : 0;
    counts.could_be += any(true) ? 1 : 0;
    counts.wrong += shown && !any(false) ? 1 : 0;
  });
  return counts;
}

}  // namespace tern_test

#endif
