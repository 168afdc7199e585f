// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From places on the globe to an autopilot's local frame, as the autopilot itself does it. So what the projection errs
// by is in the vehicle's own position, too, and between the vehicle and what is near it little is left.
#ifndef TERN_COMPANION_GLOBE_HPP
#define TERN_COMPANION_GLOBE_HPP

#include <cstdint>
#include <optional>

#include "companion/messages.hpp"
#include "tern/vec3.hpp"

namespace tern_companion {

enum class Projection : std::uint8_t {
  kAzimuthal,  ///< PX4: azimuthal equidistant, on a sphere of 6371 km
  kFlat,       ///< ArduPilot: a degree has 111.318845 km, along a parallel times the cosine of the latitude in between
};

struct LocalFrame {
  GpsGlobalOrigin origin;
  Projection projection;
};

/// m, and degrees: what is further from the origin, or an origin that is nearer to a pole, is not placed.
constexpr double kFurthestPlace = 10000.0, kHighestLatitude = 80.0;
/// Within these, the vector between two places errs by so much of its length at most. The globe is no sphere: along a
/// meridian its radius is 6335 to 6400 km, which is 0.7 %. And meridians meet: over 10 km at 80 degrees they turn by
/// 0.9 %, which the flat projection leaves out.
constexpr double kScaleError = 0.02;

/// East and north of the origin, m; z is 0. Degrees.
std::optional<tern::Vec3> place_in(const LocalFrame& frame, double latitude, double longitude);

}  // namespace tern_companion

#endif
