// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How far a zone is from the origin of a frame, and whether its latitudes and longitudes are swapped.
#ifndef TERN_HOST_AIRSPACE_ZONE_DISTANCE_HPP
#define TERN_HOST_AIRSPACE_ZONE_DISTANCE_HPP

#include <string>

#include "host/airspace/zone.hpp"

namespace tern_host {

/// Metres along the ellipsoid from the origin.
struct ZoneDistance {
  double is;       ///< of its outline's nearest point, on lines that are straight in the frame
  double swapped;  ///< the same with latitude and longitude swapped; infinite if there is no such zone

  /// True if the zone is far away, and would be near with latitude and longitude swapped.
  bool is_swapped() const;
};

ZoneDistance zone_distance(const Zone& zone, const LocalFrame& frame);

/// "4712 km from the origin", and what that comes from if they are swapped.
std::string distance_text(const ZoneDistance& distance);

}  // namespace tern_host

#endif
