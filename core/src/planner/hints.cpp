// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/hints.hpp"

#include "base/math.hpp"
#include "corridor/solid_planes.hpp"
#include "curve/bezier.hpp"
#include "grid/distance.hpp"

namespace tern {
namespace {

/// A part of a segment beside a solid.
struct Beside {
  Hull hull;
  const ConvexSolid& solid;

  double room(const Vec3& normal) const { return solid_support(normal, solid) - hull_reach(normal, hull); }
};

/// Takes normals of any length and keeps the one that leaves the most room.
struct Widest {
  const Beside& beside;
  Vec3 normal;
  double room;

  void offer(const Vec3& any) {
    const double size = length(any);
    if (!(size > 0.0)) return;
    const Vec3 unit = (1.0 / size) * any;
    const double offered = beside.room(unit);
    if (offered <= room) return;
    normal = unit;
    room = offered;
  }
};

/// The normal that leaves the most room. If the gap is below `too_close`, its normal is only rounding, or there is
/// none. If no more is wanted, the part may graze an edge of the solid. Then the axes are tried, and what is at right
/// angles to the part's direction and to an axis or an edge.
Widest widest_normal(const Beside& beside, double wanted, double too_close, Work& work) {
  work.spend(gap_operations(beside.hull.count + beside.solid.hull.count));
  const HullGap gap = solid_gap(beside.hull, beside.solid);
  Widest widest{beside, gap.normal, -1e300};
  widest.offer(gap.normal);
  if (gap.distance >= too_close || wanted > too_close) return widest;
  work.spend(ops::kDot * kHintNormals * (beside.hull.count + beside.solid.hull.count));
  const Vec3 along = beside.hull.points[beside.hull.count - 1] - beside.hull.points[0];
  for (int k = 0; k < 6; ++k) {
    Vec3 normal{0.0, 0.0, 0.0};
    axis(normal, k / 2) = k % 2 == 0 ? 1.0 : -1.0;
    widest.offer(normal);
    widest.offer(cross(normal, along));
  }
  const int faces = beside.solid.face_count < kHintFaces ? beside.solid.face_count : kHintFaces;
  for (int f = 0; f < faces; ++f) {
    for (int g = 0; g < f; ++g) {
      const Vec3 across = cross(cross(beside.solid.faces[f].normal, beside.solid.faces[g].normal), along);
      widest.offer(across);
      widest.offer(-1.0 * across);
    }
  }
  return widest;
}

/// True if a face of the solid, or a normal that is known already, leaves the room.
bool has_room(const Beside& beside, double wanted, const FenceHints& known) {
  for (int f = 0; f < beside.solid.face_count; ++f) {
    const Halfspace& face = beside.solid.faces[f];
    if (hull_support(face.normal, beside.hull) - face.offset >= wanted) return true;
  }
  for (int k = 0; k < known.count; ++k) {
    if (beside.room(known.planes[k].normal) >= wanted) return true;
  }
  return false;
}

/// A part of a segment that waits for a hint.
struct Part {
  Curve curve;
  int halvings;
};

/// Adds hints for a segment, in the world's frame, and one solid.
void add_hints(const Curve& segment, const ConvexSolid& solid, const World& world, FenceHints& hints, Work& work) {
  const double wanted = world.spec().clearance() - 2.0 * world.touching();
  const double too_close = direction_tolerance(world.spec());
  Part parts[kHintHalvings + 1];
  parts[0] = {segment, 0};
  int waiting = 1;
  while (waiting > 0) {  // kHintParts turns at most
    Part& part = parts[waiting - 1];
    const Beside beside{{part.curve.c, kControlPoints}, solid};
    --waiting;
    work.spend(ops::kDot * (kControlPoints * solid.face_count + (kControlPoints + solid.hull.count) * hints.count));
    if (has_room(beside, wanted, hints)) continue;
    const Widest widest = widest_normal(beside, wanted, too_close, work);
    if (widest.room >= wanted) {
      hints.planes[hints.count++] = {widest.normal, 0.0};  // kMaxFenceHints at most
    } else if (part.halvings < kHintHalvings) {
      work.spend(2 * ops::kCurve);
      Part first = part;
      part = {split(first.curve), ++first.halvings};
      parts[waiting + 1] = first;
      waiting += 2;
    }
  }
}

/// True if a half-space of the segment's polyhedron cuts the solid off.
bool is_known(const ConvexSolid& solid, double radius, const Corridor* corridor, int polyhedron, Work& work) {
  work.spend(ops::kPiece);
  if (corridor == nullptr || polyhedron == kNoPolyhedron) return false;
  const Polyhedron& around = corridor->polyhedra[polyhedron];
  work.spend(ops::kDot * around.count * solid.hull.count);
  return is_cut_off(solid, radius, around);
}

/// The segment in the world's frame.
Curve curve_in(const World& world, const Trajectory& curve, int segment) {
  Curve result = curve_of(curve.segments[segment]);
  const Vec3 place = curve.origin - world.spec().origin;
  for (Vec3& point : result.c) point = place + point;
  return result;
}

}  // namespace

Progress hints_advance(const World& world, const Corridor* corridor, const Trajectory& curve, PlanHints& hints,
                       Work& work) noexcept {
  if (world.solid_count() == 0) return Progress::kDone;
  for (; hints.hinted < curve.count; ++hints.hinted, hints.solid = 0) {
    FenceHints& own = hints.fences[hints.hinted];
    if (hints.solid == 0) own.count = 0;
    for (; hints.solid < world.solid_count(); ++hints.solid) {
      if (!work.left()) return Progress::kMore;
      const ConvexSolid solid = world.solid(hints.solid);
      if (is_known(solid, world.spec().clearance(), corridor, curve.segments[hints.hinted].polyhedron, work)) continue;
      add_hints(curve_in(world, curve, hints.hinted), solid, world, own, work);
    }
  }
  return Progress::kDone;
}

}  // namespace tern
