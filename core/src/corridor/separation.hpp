// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One half-space between a segment and one obstacle. Its normal is that of the ellipsoid's tangent if that leaves the
// segment its margin. Otherwise the normal turns towards the one that leaves the most room.
#ifndef TERN_CORRIDOR_SEPARATION_HPP
#define TERN_CORRIDOR_SEPARATION_HPP

#include "ellipsoid/ellipsoid_metric.hpp"
#include "grid/distance.hpp"
#include "grid/hull_gap.hpp"
#include "grid/local_boxes.hpp"
#include "tern/corridor.hpp"
#include "tern/status.hpp"

namespace tern {

/// A segment, and how far each half-space should keep from it.
struct SegmentMargin {
  Vec3 from;
  Vec3 to;
  double least;  ///< metres, > 0: kept if there is that much room
  /// Metres by which an obstacle may be nearer than the radius and still count as touching (contact_tolerance).
  double touching = kClearTolerance;
  double direction = kMetricDirection;  ///< direction_tolerance
};

/// If there is room, half-spaces keep a little more than the radius from an obstacle: this share of `least` more. That
/// outweighs the rounding of everything that follows, so no polyhedron enters an obstacle, however little.
constexpr double kHairline = 1e-8;

/// Half-spaces leave the segment this share of the room, but no more than kMostMargin metres. What they cut off near a
/// waypoint, the trajectory lacks where it turns.
constexpr double kMarginShare = 0.5;
constexpr double kMostMargin = 0.25;

/// Writes the half-space that keeps `radius` from the box and contains the segment. `tangent` is the preferred unit
/// normal; zero means no preference. The room is the distance between segment and box, less the radius. The distance
/// between half-space and segment is at least min(room, max(least, min(kMarginShare * room, kMostMargin))), apart from
/// rounding. kOk, or kCorridorBlocked if the room is negative by more than segment.touching.
Status separate(const SegmentMargin& segment, const LocalBox& box, double radius, const Vec3& tangent,
                Halfspace& out) noexcept;

/// The same for the hull of a keep-out, with the normal that leaves the most room. `faces` are the keep-out's
/// half-spaces; they are needed if the segment touches it.
Status separate(const SegmentMargin& segment, const Hull& hull, const Halfspace* faces, int face_count, double radius,
                Halfspace& out) noexcept;

}  // namespace tern

#endif
