// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "corridor/hull_polyhedron.hpp"

#include "base/math.hpp"
#include "corridor/solid_planes.hpp"
#include "grid/distance.hpp"

namespace tern {
namespace {

constexpr int kCorners = 8;

/// Takes normals of any length and keeps the one that leaves the most room between hull and solid.
struct Widest {
  const Hull& hull;
  const ConvexSolid& solid;
  Vec3 normal;
  double room;

  void offer(const Vec3& any) {
    const double size = length(any);
    if (!(size > 0.0)) return;
    const Vec3 unit = (1.0 / size) * any;
    const double offered = solid_support(unit, solid) - hull_reach(unit, hull);
    if (offered <= room) return;
    normal = unit;
    room = offered;
  }
};

/// The normal that leaves the most room between hull and solid. If their gap is below `too_close`, its normal is only
/// rounding, or there is none. Then more normals are tried: the axes, the solid's faces, and the cross products of the
/// hull's direction with the axes and with the solid's edges. The products separate the hull from an edge that the
/// curve grazes.
Vec3 widest_normal(const Hull& hull, const ConvexSolid& solid, double too_close) {
  const HullGap gap = solid_gap(hull, solid);
  if (gap.distance >= too_close) return gap.normal;
  Widest widest{hull, solid, {1.0, 0.0, 0.0}, -1e300};
  widest.offer(gap.normal);
  const Vec3 along = hull.points[hull.count - 1] - hull.points[0];
  for (int k = 0; k < 6; ++k) {
    Vec3 normal{0.0, 0.0, 0.0};
    axis(normal, k / 2) = k % 2 == 0 ? 1.0 : -1.0;
    widest.offer(normal);
    widest.offer(cross(normal, along));
  }
  for (int f = 0; f < solid.face_count; ++f) {
    widest.offer(-1.0 * solid.faces[f].normal);
    for (int g = 0; g < f; ++g) {
      const Vec3 across = cross(cross(solid.faces[f].normal, solid.faces[g].normal), along);
      widest.offer(across);
      widest.offer(-1.0 * across);
    }
  }
  return widest.normal;
}

Status append_between(const World& world, const Hull& hull, const ConvexSolid& solid, double slack,
                      GrowScratch& scratch, Polyhedron& out) {
  const double radius = world.spec().clearance();
  const Vec3 normal = widest_normal(hull, solid, direction_tolerance(world.spec()));
  const double far = hull_reach(normal, hull);
  const double offset = solid_support(normal, solid) - radius;
  const double most = offset + world.touching();
  if (far > most + slack) return Status::kCorridorBlocked;
  return append({normal, clamp(far, offset, most)}, scratch, out);
}

/// Adds the half-spaces of the box around the hull.
Status append_box(const Grid& grid, const Hull& hull, Box& box, GrowScratch& scratch, Polyhedron& out) {
  const Box boundary = grid.local_boundary();
  const double touching = contact_tolerance(grid.spec());
  Status status = Status::kOk;
  for (int a = 0; a < 3 && status == Status::kOk; ++a) {
    Vec3 normal{0.0, 0.0, 0.0};
    axis(normal, a) = 1.0;
    axis(box.upper, a) = hull_reach(normal, hull);
    axis(box.lower, a) = hull_support(normal, hull);
    if (axis(box.upper, a) > axis(boundary.upper, a) + touching) return Status::kOutOfMap;
    if (axis(box.lower, a) < axis(boundary.lower, a) - touching) return Status::kOutOfMap;
    status = append({normal, axis(box.upper, a)}, scratch, out);
    if (status == Status::kOk) status = append({-1.0 * normal, -axis(box.lower, a)}, scratch, out);
  }
  return status;
}

/// Makes the half-spaces of the hull's box, and everything else in `out` except further half-spaces.
Status make_box(const Grid& grid, const Hull& hull, GrowScratch& scratch, Polyhedron& out) {
  out.count = 0;
  out.redundant = 0;
  out.from = hull.points[0];
  out.to = hull.points[hull.count - 1];
  Box box;
  const Status status = append_box(grid, hull, box, scratch, out);
  extract_begin(voxels_within_reach(grid, box), scratch.extract);
  return status;
}

/// Looks at the next solid boxes. Each that no half-space cuts off gets one.
Status cut_off_some(HullGrowth& growth, const World& world, const Hull& hull, double slack, GrowScratch& scratch,
                    Polyhedron& out, Work& work) {
  const int left = scratch.extract.count - growth.next;
  const int tests = left < kHullTests ? left : kHullTests;
  work.spend(ops::kPiece + 4 * ops::kDot * tests * out.count);
  for (int k = 0; k < tests; ++k) {
    const LocalBox& box = scratch.boxes[growth.next++];
    Vec3 corners[kCorners];
    for (int c = 0; c < kCorners; ++c) {
      corners[c] = {(c & 1) != 0 ? box.upper[0] : box.lower[0], (c & 2) != 0 ? box.upper[1] : box.lower[1],
                    (c & 4) != 0 ? box.upper[2] : box.lower[2]};
    }
    const ConvexSolid solid = solid_of(corners, kCorners);
    if (is_cut_off(solid, world.spec().clearance(), out)) continue;
    work.spend(kGapOperations);
    return append_between(world, hull, solid, slack, scratch, out);
  }
  return Status::kOk;
}

bool inside_walls(const World& world, const Hull& hull) {
  for (int k = 0; k < world.wall_count(); ++k) {
    if (hull_reach(world.wall(k).normal, hull) > world.wall(k).offset + world.touching()) return false;
  }
  return true;
}

/// Keeps off the next solid: first all walls together, then one solid after the other.
Status keep_off(HullGrowth& growth, const World& world, const Hull& hull, double slack, GrowScratch& scratch,
                Polyhedron& out, Work& work) {
  const int index = growth.next++ - 1;
  if (index < 0) {
    work.spend(ops::kPiece + 8 * ops::kDot * world.wall_count());
    return inside_walls(world, hull) ? Status::kOk : Status::kCorridorBlocked;
  }
  work.spend(4 * kGapOperations);
  const ConvexSolid solid = world.solid(index);
  if (is_cut_off(solid, world.spec().clearance(), out)) return Status::kOk;
  return append_between(world, hull, solid, slack, scratch, out);
}

Progress extract(HullGrowth& growth, const Grid& grid, GrowScratch& scratch, Work& work) {
  const Progress progress = extract_advance(grid, scratch.extract, scratch.boxes, work);
  return progress == Progress::kFailed ? conclude(Status::kObstaclesFull, growth.status) : progress;
}

/// How many items the phase has to look at.
int count_of(HullPhase phase, const World& world, const GrowScratch& scratch) {
  if (phase == HullPhase::kBox) return 1;
  if (phase == HullPhase::kObstacles) return scratch.extract.count;
  return world.has_solids() ? 1 + world.solid_count() : 0;
}

Status do_unit(HullGrowth& growth, const World& world, const Hull& hull, double slack, GrowScratch& scratch,
               Polyhedron& out, Work& work) {
  if (growth.phase == HullPhase::kObstacles) return cut_off_some(growth, world, hull, slack, scratch, out, work);
  if (growth.phase == HullPhase::kSolids) return keep_off(growth, world, hull, slack, scratch, out, work);
  ++growth.next;
  work.spend(ops::kPiece + 8 * 12 * ops::kDot);
  return make_box(world.voxels(), hull, scratch, out);
}

/// Goes on with the current phase; kDone at its end.
Progress advance_phase(HullGrowth& growth, const World& world, const Hull& hull, double slack, GrowScratch& scratch,
                       Polyhedron& out, Work& work) {
  if (growth.phase == HullPhase::kExtract) return extract(growth, world.voxels(), scratch, work);
  while (growth.next < count_of(growth.phase, world, scratch)) {
    if (!work.left()) return Progress::kMore;
    const Status status = do_unit(growth, world, hull, slack, scratch, out, work);
    if (status != Status::kOk) return conclude(status, growth.status);
  }
  growth.next = 0;
  return Progress::kDone;
}

}  // namespace

void enclose_begin(HullGrowth& growth) noexcept {
  growth.status = Status::kOk;
  growth.phase = HullPhase::kBox;
  growth.next = 0;
}

Progress enclose_advance(HullGrowth& growth, const World& world, const Hull& hull, double slack, GrowScratch& scratch,
                         Polyhedron& out, Work& work) noexcept {
  while (growth.phase != HullPhase::kDone) {
    const Progress progress = advance_phase(growth, world, hull, slack, scratch, out, work);
    if (progress != Progress::kDone) return progress;
    growth.phase = static_cast<HullPhase>(static_cast<int>(growth.phase) + 1);
  }
  return Progress::kDone;
}

Status enclose_hull(const World& world, const Hull& hull, double slack, GrowScratch& scratch,
                    Polyhedron& out) noexcept {
  HullGrowth growth;
  enclose_begin(growth);
  Work all{0xFFFFFFFFu};
  enclose_advance(growth, world, hull, slack, scratch, out, all);
  return growth.status;
}

}  // namespace tern
