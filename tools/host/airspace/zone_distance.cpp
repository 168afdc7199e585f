// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/airspace/zone_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host/number.hpp"

namespace tern_host {
namespace {

/// A file of a whole country has zones that are farther away than this, and none of them would be so near if swapped.
constexpr double kFar = 100e3;

constexpr double kNowhere = std::numeric_limits<double>::infinity();

/// Of the origin from the line between two points.
double distance_to_line(const Plan2& a, const Plan2& b) {
  const double x = b.east - a.east, y = b.north - a.north, square = x * x + y * y;
  const double t = square > 0.0 ? std::clamp(-(a.east * x + a.north * y) / square, 0.0, 1.0) : 0.0;
  return std::hypot(a.east + t * x, a.north + t * y);
}

double distance_to_ring(const std::vector<GeoPoint>& ring, const LocalFrame& frame) {
  double least = kNowhere;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    least = std::min(least, distance_to_line(frame.plan(ring[i]), frame.plan(ring[(i + 1) % ring.size()])));
  }
  return least;
}

double distance_of(const std::vector<ZoneArea>& areas, const LocalFrame& frame) {
  double least = kNowhere;
  for (const ZoneArea& area : areas) {
    if (area.radius > 0.0) {
      const Plan2 centre = frame.plan(area.centre);
      least = std::min(least, std::fabs(std::hypot(centre.east, centre.north) - area.radius));
    }
    least = std::min(least, distance_to_ring(area.ring, frame));
  }
  return least;
}

bool swap(GeoPoint& point) {
  std::swap(point.latitude, point.longitude);
  return std::fabs(point.latitude) <= 90.0;
}

std::string length_text(double metres) {
  return metres < 10e3 ? fixed(metres, 0) + " m" : fixed(1e-3 * metres, 0) + " km";
}

}  // namespace

bool ZoneDistance::is_swapped() const {
  return is > kFar && swapped < kFar;
}

ZoneDistance zone_distance(const Zone& zone, const LocalFrame& frame) {
  std::vector<ZoneArea> other = zone.areas;
  bool may_swap = true;
  for (ZoneArea& area : other) {
    may_swap = swap(area.centre) && may_swap;
    for (GeoPoint& corner : area.ring) may_swap = swap(corner) && may_swap;
  }
  return {distance_of(zone.areas, frame), may_swap ? distance_of(other, frame) : kNowhere};
}

std::string distance_text(const ZoneDistance& distance) {
  const std::string text = length_text(distance.is) + " from the origin";
  if (!distance.is_swapped()) return text;
  return text + ", and " + length_text(distance.swapped) + " with latitude and longitude swapped";
}

}  // namespace tern_host
