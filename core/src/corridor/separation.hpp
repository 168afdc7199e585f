// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One half-space between a segment and one obstacle: as the ellipsoid's tangent has it where that leaves the segment
// its margin, turned towards the widest gap where it does not.
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
  double least;  ///< metres, > 0: kept wherever there is that much room
  /// Metres by which an obstacle may be nearer than the radius and still count as touching (contact_tolerance).
  double touching = kClearTolerance;
  double direction = kMetricDirection;  ///< direction_tolerance
};

/// Half-spaces keep this part of `least` more from an obstacle than the radius where there is room: what outweighs the
/// rounding of all that follows, so that no polyhedron enters an obstacle by however little.
constexpr double kHairline = 1e-8;

/// Half-spaces keep this share of the room there is, but no more than kMostMargin metres: what they take from the
/// neighbourhood of a waypoint is missing where the trajectory turns.
constexpr double kMarginShare = 0.5;
constexpr double kMostMargin = 0.25;

/// The half-space that keeps `radius` from the box and holds the segment; `tangent` is the wanted unit normal, zero
/// where there is none. The room is the distance between segment and box, less the radius; the half-space's distance
/// from the segment is min(room, max(least, min(kMarginShare * room, kMostMargin))) at least, to rounding.
/// kOk, or kCorridorBlocked where the room is negative by more than segment.touching.
Status separate(const SegmentMargin& segment, const LocalBox& box, double radius, const Vec3& tangent,
                Halfspace& out) noexcept;

/// The same for a keep-out's hull, at the normal that leaves the most room; `faces` are its half-spaces, for a segment
/// that touches it.
Status separate(const SegmentMargin& segment, const Hull& hull, const Halfspace* faces, int face_count, double radius,
                Halfspace& out) noexcept;

}  // namespace tern

#endif
