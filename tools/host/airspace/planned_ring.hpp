// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Outlines in degrees as outlines of a local frame with straight edges, and how far those are off.
#ifndef TERN_HOST_AIRSPACE_PLANNED_RING_HPP
#define TERN_HOST_AIRSPACE_PLANNED_RING_HPP

#include <vector>

#include "host/airspace/convex_pieces.hpp"
#include "host/airspace/local_frame.hpp"
#include "host/airspace/zone.hpp"

namespace tern_host {

/// Where outlines matter: a square about the origin, metres from it to its sides.
struct Window {
  double reach;
};

/// A closed outline, in steps. Within the window, it winds around every place as the original does, but for places no
/// farther from it than `slack`, metres; beyond the window, it is cut off or anything. Empty: it is nowhere near.
struct PlannedRing {
  std::vector<Corner> corners;
  double slack = 0.0;
};

/// A polygon's ring. Edges are cut until they are straight to `tolerance`, metres; with EdgeRule::kEither, the
/// difference between the two rules comes on top. Longitudes go the shorter way round. Throws std::invalid_argument
/// with a reason where an edge goes half around the earth, or the ring is not all within 5000 km of the origin, nor all
/// beyond.
PlannedRing planned_ring(const LocalFrame& frame, const std::vector<GeoPoint>& ring, EdgeRule rule, double tolerance,
                         const Window& window);

/// A regular polygon around the circle or, if `inside`, within it, off by at most `looseness`, metres. `radius` is up
/// to 500 km. `off` is by how much its corners or, if inside, its edges are off the circle.
PlannedRing planned_circle(const LocalFrame& frame, const GeoPoint& centre, double radius, bool inside,
                           double looseness, const Window& window, double& off);

}  // namespace tern_host

#endif
