// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "corridor/separation.hpp"

#include "base/math.hpp"
#include "grid/distance.hpp"
#include "grid/touching.hpp"

namespace tern {
namespace {

/// The room between the segment and the box grown by the radius, along a normal and in units of its length. It is a
/// concave function of the normal: a mean of two normals leaves at least the mean of their rooms.
double room_along(const SegmentMargin& segment, const LocalBox& box, double radius, const Vec3& normal) {
  return room_along(segment.from, segment.to, box_of(box), normal) - radius * length(normal);
}

/// The half-space with this normal that keeps the radius from the box. It contains the segment in spite of rounding.
Halfspace plane_along(const SegmentMargin& segment, const LocalBox& box, double radius, const Vec3& normal) {
  const Vec3 unit = (1.0 / length(normal)) * normal;
  const double far = larger(dot(unit, segment.from), dot(unit, segment.to));
  return {unit, larger(support(unit, box_of(box)) - radius - kHairline * segment.least, far)};
}

/// The half-space with normal `unit` that keeps the radius from the solid. `far` is the largest unit . p over the
/// segment.
Halfspace plane_before(const ConvexSolid& solid, double radius, double hair, const Vec3& unit, double far) {
  return {unit, larger(solid_support(unit, solid) - radius - hair, far)};
}

/// The most by which a normal's room may fall short of the gap, as a share of SegmentMargin::touching.
constexpr double kShortOfGap = 0.25;

/// The normal that leaves the segment the most room, and that room. In exact arithmetic it is the direction of the
/// closest pair, and the room is the gap. If the pair is very close, rounding turns its direction, and the room falls
/// short of the gap, the more so for a long segment. Then the candidates are the pair's direction, the same without its
/// part along the segment and, for a pair closer than segment.direction, the box's separating axes.
WidestNormal widest_normal(const SegmentMargin& segment, const Box& box) {
  const ClosestPair pair = segment_box_closest(segment.from, segment.to, box);
  const Vec3 across = pair.on_box - pair.on_segment;
  const double gap = length(across);
  WidestNormal best{across, 0.0};
  if (gap < segment.direction) {
    best = separating_normal(segment.from, segment.to, box, segment.direction);
  } else {
    best.normal = (1.0 / gap) * across;
    best.room = room_along(segment.from, segment.to, box, best.normal);
  }
  if (!(gap > 0.0) || best.room >= gap - kShortOfGap * segment.touching) return best;
  offer(segment.from, segment.to, box, (1.0 / gap) * across, best);
  const Vec3 along = segment.to - segment.from;
  const Vec3 upright = across - (dot(across, along) / dot(along, along)) * along;
  const double size = length(upright);
  if (size > 0.0) offer(segment.from, segment.to, box, (1.0 / size) * upright, best);
  return best;
}

}  // namespace

Status separate(const SegmentMargin& segment, const LocalBox& box, double radius, const Vec3& tangent,
                Halfspace& out) noexcept {
  const double tangent_room = room_along(segment, box, radius, tangent);
  const bool has_tangent = dot(tangent, tangent) > 0.5;
  if (has_tangent && tangent_room >= larger(segment.least, kMostMargin)) {
    out = plane_along(segment, box, radius, tangent);
    return Status::kOk;
  }
  const WidestNormal widest = widest_normal(segment, box_of(box));
  const double room = widest.room - radius * length(widest.normal);
  if (room < -segment.touching) return Status::kCorridorBlocked;
  const double margin = larger(segment.least, smaller(kMarginShare * room, kMostMargin));
  if (!has_tangent || room <= margin) {
    out = plane_along(segment, box, radius, widest.normal);
  } else if (tangent_room >= margin) {
    out = plane_along(segment, box, radius, tangent);
  } else {
    // Between the two normals, as close to the tangent as the margin allows: see room_along.
    const double share = (margin - tangent_room) / (room - tangent_room);
    out = plane_along(segment, box, radius, (1.0 - share) * tangent + share * widest.normal);
  }
  return Status::kOk;
}

Status separate(const SegmentMargin& segment, const ConvexSolid& solid, double radius, Halfspace& out) noexcept {
  const double enough = radius + segment.direction;
  const Vec3 unit = solid_gap(segment.from, segment.to, solid, enough).normal;
  const double far = larger(dot(unit, segment.from), dot(unit, segment.to));
  if (solid_support(unit, solid) - far < radius - segment.touching) return Status::kCorridorBlocked;
  out = plane_before(solid, radius, kHairline * segment.least, unit, far);
  return Status::kOk;
}

}  // namespace tern
