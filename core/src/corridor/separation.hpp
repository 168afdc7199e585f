// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One half-space between a segment and one obstacle. Its normal is that of the ellipsoid's tangent if that leaves the
// segment its margin. Otherwise the normal turns towards the one that leaves the most room.
#ifndef TERN_CORRIDOR_SEPARATION_HPP
#define TERN_CORRIDOR_SEPARATION_HPP

#include "ellipsoid/ellipsoid_metric.hpp"
#include "grid/distance.hpp"
#include "grid/local_boxes.hpp"
#include "tern/corridor.hpp"
#include "tern/status.hpp"
#include "world/solids.hpp"

namespace tern {

/// A segment, and the distance that each half-space should keep from it.
struct SegmentMargin {
  Vec3 from;
  Vec3 to;
  double least;  ///< metres, > 0: kept if there is that much room
  /// Metres by which an obstacle may be nearer than the radius and still count as touching (contact_tolerance).
  double touching = kClearTolerance;
  double direction = kMetricDirection;  ///< direction_tolerance
};

/// If there is room, half-spaces keep slightly more than the radius from an obstacle: this share of `least` more. That
/// outweighs the rounding of all later steps, so that no polyhedron enters an obstacle, not even slightly.
constexpr double kHairline = 1e-8;

/// Half-spaces leave the segment this share of the room, but no more than kMostMargin metres. Room that they cut off
/// near a waypoint is missing where the trajectory turns.
constexpr double kMarginShare = 0.5;
constexpr double kMostMargin = 0.25;

/// Writes the half-space that keeps `radius` from the box and contains the segment. `tangent` is the preferred unit
/// normal; zero means no preference. The room is the distance between segment and box, less the radius. The distance
/// between half-space and segment is at least min(room, max(least, min(kMarginShare * room, kMostMargin))), apart from
/// rounding. kOk, or kCorridorBlocked if the room is negative by more than segment.touching.
Status separate(const SegmentMargin& segment, const LocalBox& box, double radius, const Vec3& tangent,
                Halfspace& out) noexcept;

/// Writes the half-space that keeps `radius` from the solid and contains the segment. Its normal leaves the most room.
/// kOk, or kCorridorBlocked as for a box.
Status separate(const SegmentMargin& segment, const ConvexSolid& solid, double radius, Halfspace& out) noexcept;

}  // namespace tern

#endif
