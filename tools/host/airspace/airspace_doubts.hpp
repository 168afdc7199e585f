// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is allowed, but most likely a mistake. Each returns a warning, or nothing where there is no doubt.
#ifndef TERN_HOST_AIRSPACE_AIRSPACE_DOUBTS_HPP
#define TERN_HOST_AIRSPACE_AIRSPACE_DOUBTS_HPP

#include <string>
#include <vector>

#include "host/airspace/airspace.hpp"

namespace tern_host {

/// The stated ground does not hold the origin.
std::string doubt_of_ground(const HeightSources& sources, const ZoneHeights& heights);

/// A mission's home is at the origin, but at another height.
std::string doubt_of_home(const HeightSources& sources, const ZoneHeights& heights);

/// A keep-out ends at or below the lowest ground that is under it in the boundary. If that means all heights in its
/// format, it has them afterwards, and a note.
std::string doubt_of_heights(Zone& zone, const ZoneHeights& heights, const tern::Box& boundary);

/// Points of a mission are outside the boundary.
std::string doubt_of_points(const std::vector<LocalPoint>& points, const tern::Box& boundary);

}  // namespace tern_host

#endif
