// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Free means seen, for scans, by brute force: random sensors that keep the promise of tern::Beams, in worlds of random
// things. No voxel that holds a part of a thing may be seen. Nothing here knows how the map looks at a scan.
#ifndef TERN_TESTS_SUPPORT_SEEN_SCAN_HPP
#define TERN_TESTS_SUPPORT_SEEN_SCAN_HPP

#include <vector>

#include "support/scan_patterns.hpp"
#include "support/seen_reference.hpp"

namespace tern_test {

/// Rotates by a quaternion.
inline Vec3 rotated(const double (&q)[4], const Vec3& p) {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  return {(1 - 2 * (y * y + z * z)) * p.x + 2 * (x * y - w * z) * p.y + 2 * (x * z + w * y) * p.z,
          2 * (x * y + w * z) * p.x + (1 - 2 * (x * x + z * z)) * p.y + 2 * (y * z - w * x) * p.z,
          2 * (x * z - w * y) * p.x + 2 * (y * z + w * x) * p.y + (1 - 2 * (x * x + y * y)) * p.z};
}

/// The voxel of a point; outside the window where the point is too near to a face of its voxel to tell.
inline Voxel voxel_at(const MapSpec& spec, const Vec3& point, double off) {
  const double from[] = {point.x - spec.origin.x, point.y - spec.origin.y, point.z - spec.origin.z};
  int voxel[3];
  for (int a = 0; a < 3; ++a) {
    const double cells = from[a] / spec.cell;
    if (std::abs(cells - std::round(cells)) < off) return {-1, -1, -1};
    voxel[a] = static_cast<int>(std::floor(cells));
  }
  return {voxel[0], voxel[1], voxel[2]};
}

/// Things as points, world frame: wires, plates, balls and motes, so small that only wide beams show them.
inline std::vector<Vec3> random_points(Random& random, const MapSpec& spec) {
  std::vector<Vec3> points;
  const auto on = [&](double origin, int count) { return origin + count * spec.cell * random.unit(); };
  for (int thing = random.integer(1, 20); thing > 0; --thing) {
    const Vec3 at{on(spec.origin.x, spec.dims.x), on(spec.origin.y, spec.dims.y), on(spec.origin.z, spec.dims.z)};
    const Vec3 along = random_direction(random), across = random_direction(random);
    const double size = random.real(0.0, 0.3) * spec.range;
    const int kind = random.chance(0.8) ? 0 : random.integer(1, 3), count = kind == 0 ? 1 : 20;
    for (int k = 0; k < count; ++k) {
      const double a = kind == 0 ? 0.0 : random.real(-1, 1) * size, b = kind < 2 ? 0.0 : random.real(-1, 1) * size;
      const Vec3 out = random_direction(random);
      points.push_back(kind == 3 ? Vec3{at.x + size * out.x, at.y + size * out.y, at.z + size * out.z}
                                 : Vec3{at.x + a * along.x + b * across.x, at.y + a * along.y + b * across.y,
                                        at.z + a * along.z + b * across.z});
    }
  }
  return points;
}

/// Boxes that thin beams show: as thick as the promise asks. The sensor is in none of them.
inline std::vector<tern::Box> random_boxes(Random& random, const MapSpec& spec, const Vec3& eye) {
  std::vector<tern::Box> boxes;
  const double thick = 0.75 * spec.scan_pixel * spec.range;
  for (int k = random.integer(1, 8); k > 0; --k) {
    const auto on = [&](double origin, int count) { return origin + count * spec.cell * random.unit(); };
    const Vec3 lower{on(spec.origin.x, spec.dims.x), on(spec.origin.y, spec.dims.y), on(spec.origin.z, spec.dims.z)};
    const auto edge = [&] { return random.chance(0.5) ? thick : thick + random.real(0.0, 0.5) * spec.range; };
    const tern::Box box{lower, {lower.x + edge(), lower.y + edge(), lower.z + edge()}};
    const bool inside = eye.x > box.lower.x && eye.y > box.lower.y && eye.z > box.lower.z && eye.x < box.upper.x &&
                        eye.y < box.upper.y && eye.z < box.upper.z;
    if (!inside) boxes.push_back(box);
  }
  return boxes;
}

/// Distance along a ray to a box; far away where it misses.
inline double cast(const Vec3& eye, const Vec3& unit, const tern::Box& box) {
  const double from[] = {eye.x, eye.y, eye.z}, along[] = {unit.x, unit.y, unit.z};
  const double lower[] = {box.lower.x, box.lower.y, box.lower.z}, upper[] = {box.upper.x, box.upper.y, box.upper.z};
  double enter = 0.0, leave = kNothing;
  for (int a = 0; a < 3; ++a) {
    const double p = (lower[a] - from[a]) / along[a], q = (upper[a] - from[a]) / along[a];
    enter = std::max(enter, std::min(p, q));
    leave = std::min(leave, std::max(p, q));
  }
  return enter < leave ? enter : kNothing;
}

/// A sensor in a world: where it is and how it is turned, and what the map is told of that.
struct ScanCase {
  MapSpec spec;
  Vec3 eye;
  double turn[4];
  Pose told;
  Pattern pattern;
  std::vector<double> ranges;  ///< true ones
};

inline ScanCase random_case(Random& random, const MapSpec& spec, bool thin) {
  ScanCase c{spec, inside_window(random, spec), {}, {}, random_pattern(random, spec.scan_pixel, thin), {}};
  random_quaternion(random, c.turn);
  c.told = wrong_pose(random, spec, {c.eye, {1.0, 0.0, 0.0, 0.0}});
  c.ranges.assign(c.pattern.beams.size(), kNothing);
  return c;
}

/// What wide beams measure: each thing is shown by the beam that answers for its direction, if there is one.
inline void measure(ScanCase& c, const std::vector<Vec3>& points) {
  const double back[] = {c.turn[0], -c.turn[1], -c.turn[2], -c.turn[3]};
  for (const Vec3& p : points) {
    const Vec3 ray = rotated(back, {p.x - c.eye.x, p.y - c.eye.y, p.z - c.eye.z});
    const double far = std::sqrt(ray.x * ray.x + ray.y * ray.y + ray.z * ray.z);
    const int beam = c.pattern.owner({ray.x / far, ray.y / far, ray.z / far});
    if (beam >= 0) c.ranges[static_cast<std::size_t>(beam)] = std::min(c.ranges[static_cast<std::size_t>(beam)], far);
  }
}

inline void measure(ScanCase& c, const std::vector<tern::Box>& boxes) {
  for (std::size_t k = 0; k < c.ranges.size(); ++k) {
    const Vec3 unit = rotated(c.turn, c.pattern.beams[k]);
    for (const tern::Box& box : boxes) c.ranges[k] = std::min(c.ranges[k], cast(c.eye, unit, box));
  }
}

/// Enters the scan as points or as beams, with errors up to the margins; some beams say that they know nothing. Counts
/// the hits.
inline bool enter(Random& random, const ScanCase& c, OwnedMap& owned, SeenCounts& counts) {
  const MapSpec& spec = c.spec;
  const bool by_range = c.pattern.unknown > 0.0 || random.chance(0.5);
  std::vector<Vec3> directions, points;
  std::vector<float> ranges;
  for (std::size_t k = 0; k < c.ranges.size(); ++k) {
    const Vec3 unit = rotated(c.told.quaternion, rotated(c.turn, c.pattern.beams[k]));
    const double true_range = c.ranges[k];
    const double error = spec.depth_margin + spec.depth_margin_square * true_range * true_range;
    const bool none = true_range >= kNothing;
    const double range = none ? 2.0 * spec.range / 0.5 : std::max(true_range + random.real(-1, 1) * error, 1e-3);
    const float odd[] = {NAN, -INFINITY, 0.0f, -1.0f, 0.009f, 1e4f};
    const bool known = !random.chance(c.pattern.unknown);
    directions.push_back({3.0 * unit.x, 3.0 * unit.y, 3.0 * unit.z});
    ranges.push_back(known ? (none ? INFINITY : static_cast<float>(range)) : odd[random.integer(0, 5)]);
    const Vec3& o = c.told.position;
    points.push_back({o.x + range * unit.x, o.y + range * unit.y, o.z + range * unit.z});
  }
  const tern::Beams beams{directions.data(), ranges.data(), ranges.size(), 0.01, 1e3};
  const Status begun = by_range ? owned.map.begin_scan(beams, c.told.position, 0)
                                : owned.map.begin_scan(points.data(), points.size(), c.told.position, 0);
  if (begun != Status::kRunning || finish(owned.map) != Status::kOk) return false;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double range = by_range ? static_cast<double>(ranges[k]) : c.ranges[k] < kNothing ? 0.02 : -1.0;
    const Vec3 from{points[k].x - c.told.position.x, points[k].y - c.told.position.y, points[k].z - c.told.position.z};
    const double far = std::sqrt(from.x * from.x + from.y * from.y + from.z * from.z);
    const bool hits = range >= 0.01 && range < 1e3 && far > 0.02 && far < spec.range * (1 - 1e-5);
    if (hits) count_hit(owned.map, voxel_at(spec, points[k], 2e-3), counts);
  }
  return true;
}

inline MapSpec random_scan_spec(Random& random) {
  MapSpec spec = random_spec(random);
  spec.dims = {random.integer(30, 80), random.integer(20, 40), random.integer(10, 40)};
  spec.scan_pixel = random.real(0.06, 0.15);
  spec.range = spec.cell * random.real(12.0, 30.0);
  spec.depth_margin *= random.unit();
  spec.depth_margin_square *= 0.1;
  spec.angle_margin *= 0.3;
  spec.pixels = 6 * 63 * 63;
  return spec;
}

/// Enters one random scan into a new map, and looks at each voxel that holds a thing. The map is told an origin and
/// axes that are wrong by as much as its margins allow.
inline SeenCounts check_scan(Random& random, const MapSpec& spec) {
  const bool thin = random.chance(0.3);
  ScanCase c = random_case(random, spec, thin);
  const std::vector<Vec3> points = thin ? std::vector<Vec3>{} : random_points(random, spec);
  const std::vector<tern::Box> boxes = thin ? random_boxes(random, spec, c.eye) : std::vector<tern::Box>{};
  thin ? measure(c, boxes) : measure(c, points);
  OwnedMap owned(spec);
  SeenCounts counts;
  counts.frames = 1;
  counts.refused = enter(random, c, owned, counts) ? 0 : 1;
  for_each_voxel(spec.dims, [&](const Voxel& v) { counts.shown += owned.map.seen(v) ? 1 : 0; });
  for (const Vec3& point : points) {
    const Voxel v = voxel_at(spec, point, 1e-9);
    if (!owned.map.route().inside(v)) continue;
    ++counts.could_be;
    counts.wrong += owned.map.seen(v) ? 1 : 0;
  }
  for_each_voxel(spec.dims, [&](const Voxel& v) {
    const auto apart = [&](double at, int index, double lower, double upper) {
      return at + (index + 1) * spec.cell <= lower + 1e-9 || at + index * spec.cell >= upper - 1e-9;
    };
    for (const tern::Box& b : boxes) {
      const bool held = !apart(spec.origin.x, v.x, b.lower.x, b.upper.x) &&
                        !apart(spec.origin.y, v.y, b.lower.y, b.upper.y) &&
                        !apart(spec.origin.z, v.z, b.lower.z, b.upper.z);
      counts.could_be += held ? 1 : 0;
      counts.wrong += held && owned.map.seen(v) ? 1 : 0;
    }
  });
  return counts;
}

}  // namespace tern_test

#endif
