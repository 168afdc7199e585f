// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The world frame of a flight on the earth: x east, y north, z up about an origin.
#ifndef TERN_HOST_AIRSPACE_LOCAL_FRAME_HPP
#define TERN_HOST_AIRSPACE_LOCAL_FRAME_HPP

#include <GeographicLib/AzimuthalEquidistant.hpp>

#include "tern/vec3.hpp"

namespace tern_host {

/// Degrees on the WGS84 ellipsoid, latitude within [-90, 90].
struct GeoPoint {
  double latitude;
  double longitude;
};

/// A point on the plane of a local frame, metres.
struct Plan2 {
  double east;
  double north;
};

/// Degrees, and metres above the WGS84 ellipsoid.
struct GeoPosition {
  GeoPoint point;
  double height;
};

/// The ellipsoid's smallest radius of curvature, metres: along the meridian, at the equator.
constexpr double kLeastRadius = 6335439.0;

/// The largest error of lengths that a frame is used with, metres, and the largest latitude of its origin.
constexpr double kMostLengthError = 0.01;
constexpr double kMostLatitude = 80.0;

/// East and north are those of the azimuthal equidistant projection: a point's distance and bearing from the origin
/// along the ellipsoid are exact. Up is the height above the ellipsoid less the origin's, so that a level surface is a
/// level plane and a vertical wall is upright, as in the local frames of autopilots. Conversions are exact to
/// nanometres in both directions. Lengths are not, because the earth is round: length_error() and height_scale() say by
/// how much.
class LocalFrame {
 public:
  /// `height`: of the origin above the WGS84 ellipsoid, metres. Throws std::invalid_argument where a number is not
  /// finite, or the origin is nearer to a pole than kMostLatitude.
  explicit LocalFrame(const GeoPosition& origin);

  Plan2 plan(const GeoPoint& point) const;
  GeoPoint point(const Plan2& plan) const;
  tern::Vec3 local(const GeoPosition& position) const;
  GeoPosition position(const tern::Vec3& local) const;

  const GeoPosition& origin() const { return origin_; }

 private:
  GeoPosition origin_;
  GeographicLib::AzimuthalEquidistant projection_;
};

/// A bound on how far the length of any line between two points is from its length along the ellipsoid, metres, if both
/// are at most `radius` metres from the origin. 8.3 mm for 10 km.
double length_error(double radius);

/// The largest radius with length_error(radius) <= kMostLengthError, metres: 10.6 km.
double largest_radius();

/// By which part lengths at `height` metres above the ellipsoid are longer than in the frame, at most.
double height_scale(double height);

}  // namespace tern_host

#endif
