// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A zone as convex fences of a local frame, on the safe side: keep-outs cover it, and a keep-in is within it.
#ifndef TERN_HOST_AIRSPACE_ZONE_FENCES_HPP
#define TERN_HOST_AIRSPACE_ZONE_FENCES_HPP

#include <string>
#include <vector>

#include "host/airspace/convex_pieces.hpp"
#include "host/airspace/zone.hpp"
#include "host/airspace/zone_heights.hpp"
#include "tern/fence.hpp"
#include "tern/grid.hpp"

namespace tern_host {

/// Where fences matter, and how loosely they may fit. Metres.
struct FitSettings {
  tern::Box boundary;      ///< of the flight, in the local frame
  double clearance = 0.5;  ///< that it keeps from keep-outs: radius and tracking margin
  double looseness = 1.0;  ///< how far a fence's sides may be from the zone's outline, in plan
};

/// A convex fence. Half-spaces that hold all of the boundary, grown by the clearance, are left out.
struct FittedFence {
  tern::FenceKind kind;
  std::vector<tern::Halfspace> planes;
  std::vector<ConvexPiece::Vertex> outline;  ///< of the piece in plan, to draw it; before it was grown
  double bottom;                             ///< m; infinite where it has no end
  double top;
};

/// What became of a zone.
struct FittedZone {
  std::vector<FittedFence> fences;  ///< none: it does not reach the boundary, or is flat
  bool flat = false;                ///< there is an outline near the boundary, but no area in it
  bool above = false;               ///< it is where the boundary is, but at other heights
  double area = 0.0;                ///< m^2, of the part up to a kilometre around the boundary
  double off = 0.0;                 ///< m: no fence's side is farther from the zone's outline than this, in plan
  double height_off = 0.0;          ///< m: the same of bottom and top, because the geoid or the ground is not level
  std::vector<std::string> notes;   ///< what was made of it that its file does not say
};

/// Throws std::invalid_argument where the settings are no settings: a boundary without room or farther away than a
/// frame is good for, a clearance or looseness out of range.
void check_fit(const FitSettings& settings);

/// A keep-in that is not convex becomes a convex keep-in and keep-outs of what that has too much; one with times,
/// keep-outs of all around it. Throws std::invalid_argument with the reason where a zone cannot be made fences of.
FittedZone fit_zone(const Zone& zone, const ZoneHeights& heights, const FitSettings& settings);

}  // namespace tern_host

#endif
