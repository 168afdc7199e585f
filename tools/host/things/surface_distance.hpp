// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_THINGS_SURFACE_DISTANCE_HPP
#define TERN_HOST_THINGS_SURFACE_DISTANCE_HPP

#include <algorithm>
#include <cmath>

#include "tern/track.hpp"
#include "tern/vec3.hpp"

namespace tern_host {

/// Of a shape that is the product of a disc or interval `across` and an interval `up`: how far beyond each a point is.
inline double distance_beyond(double across, double up) {
  const double outside = std::hypot(std::max(across, 0.0), std::max(up, 0.0));
  return outside > 0.0 ? outside : std::max(across, up);
}

/// Signed distance of a point from the surface of a Thing or a Track whose centre is at `center`, m; negative inside.
template <typename Shaped>
double surface_distance(const Shaped& thing, const tern::Vec3& center, const tern::Vec3& point) {
  const tern::Vec3 d{point.x - center.x, point.y - center.y, point.z - center.z};
  if (thing.shape == tern::TrackShape::kBall) return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z) - thing.radius;
  const double up = std::abs(d.z) - thing.half.z;
  if (thing.shape == tern::TrackShape::kCylinder) {
    return distance_beyond(std::sqrt(d.x * d.x + d.y * d.y) - thing.radius, up);
  }
  const double level = distance_beyond(std::abs(d.x) - thing.half.x, std::abs(d.y) - thing.half.y);
  return distance_beyond(level, up);
}

/// By how much the radius and the half extents of a Thing or a Track whose centre is at `center` must grow until it
/// holds a point, m; negative inside. For a point beyond an edge or a corner, that is less than its distance.
template <typename Shaped>
double growth_until(const Shaped& thing, const tern::Vec3& center, const tern::Vec3& point) {
  const tern::Vec3 d{point.x - center.x, point.y - center.y, point.z - center.z};
  const double up = std::abs(d.z) - thing.half.z;
  switch (thing.shape) {
    case tern::TrackShape::kCylinder:
      return std::max(std::hypot(d.x, d.y) - thing.radius, up);
    case tern::TrackShape::kBox:
      return std::max({std::abs(d.x) - thing.half.x, std::abs(d.y) - thing.half.y, up});
    case tern::TrackShape::kBall:
      break;
  }
  return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z) - thing.radius;
}

/// By how much a track may be off after `age` s, without regard to its reach, m.
inline double error_after(const tern::Track& track, double age) {
  return track.error + track.error_speed * age + 0.5 * track.error_growth * age * age;
}

}  // namespace tern_host

#endif
