// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/airspace/local_frame.hpp"

#include <cmath>
#include <stdexcept>

namespace tern_host {
LocalFrame::LocalFrame(const GeoPosition& origin) : origin_(origin), projection_(GeographicLib::Geodesic::WGS84()) {
  const bool finite =
      std::isfinite(origin.point.latitude) && std::isfinite(origin.point.longitude) && std::isfinite(origin.height);
  if (!finite) throw std::invalid_argument("the origin is not finite");
  if (!(std::fabs(origin.point.latitude) <= kMostLatitude)) {
    throw std::invalid_argument("the origin is beyond 80 degrees of latitude, which comes before the longitude");
  }
}

Plan2 LocalFrame::plan(const GeoPoint& point) const {
  Plan2 plan{};
  projection_.Forward(origin_.point.latitude, origin_.point.longitude, point.latitude, point.longitude, plan.east,
                      plan.north);
  return plan;
}

GeoPoint LocalFrame::point(const Plan2& plan) const {
  GeoPoint point{};
  projection_.Reverse(origin_.point.latitude, origin_.point.longitude, plan.east, plan.north, point.latitude,
                      point.longitude);
  return point;
}

tern::Vec3 LocalFrame::local(const GeoPosition& position) const {
  const Plan2 at = plan(position.point);
  return {at.east, at.north, position.height - origin_.height};
}

GeoPosition LocalFrame::position(const tern::Vec3& local) const {
  return {point({local.x, local.y}), local.z + origin_.height};
}

double length_error(double radius) {
  // Across the direction to the origin, a length r away from it is stretched by r / (R sin(r / R)); along it, not at
  // all. The line is at most two radii long.
  const double angle = radius / kLeastRadius;
  if (!(angle > 0.0)) return 0.0;
  if (!(angle < 1.0)) return radius;
  return 2.0 * radius * (angle / std::sin(angle) - 1.0);
}

double largest_radius() {
  return std::cbrt(3.0 * kMostLengthError * kLeastRadius * kLeastRadius) * (1.0 - 1e-6);
}

double height_scale(double height) {
  return std::fabs(height) / kLeastRadius;
}

}  // namespace tern_host
