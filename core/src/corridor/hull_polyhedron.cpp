// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "corridor/hull_polyhedron.hpp"

#include "base/math.hpp"
#include "corridor/fence_planes.hpp"
#include "grid/distance.hpp"

namespace tern {
namespace {

/// Semi-axes of the stand-in ellipsoid, metres. It is never grown.
constexpr double kNoSize = 1e-7;

constexpr int kCorners = 8;

/// Takes normals of any length and keeps the one that leaves the most room between hull and solid.
struct Widest {
  const Hull& hull;
  const Hull& solid;
  Vec3 normal;
  double room;

  void offer(const Vec3& any) {
    const double size = length(any);
    if (!(size > 0.0)) return;
    const Vec3 unit = (1.0 / size) * any;
    const double offered = hull_support(unit, solid) - hull_reach(unit, hull);
    if (offered <= room) return;
    normal = unit;
    room = offered;
  }
};

/// Faces of a solid that is not a box.
struct Faces {
  const Halfspace* at;
  int count;
};

/// If the gap is below `too_close`, its normal is rounding, if it exists at all. Then these normals are tried too: the
/// axes and the solid's faces, and the cross products of the hull's direction with the axes and with the solid's edges.
/// The products separate an edge that the curve grazes.
Vec3 widest_normal(const Hull& hull, const Hull& solid, const Faces& faces, double too_close) {
  const HullGap gap = hull_gap(hull, solid);
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
  for (int f = 0; f < faces.count; ++f) {
    widest.offer(-1.0 * faces.at[f].normal);
    for (int g = 0; g < f; ++g) {
      const Vec3 across = cross(cross(faces.at[f].normal, faces.at[g].normal), along);
      widest.offer(across);
      widest.offer(-1.0 * across);
    }
  }
  return widest.normal;
}

Status append_between(const Grid& grid, const Hull& hull, const Hull& solid, const Faces& faces, double slack,
                      GrowScratch& scratch, Polyhedron& out) {
  const double radius = grid.spec().clearance();
  const Vec3 normal = widest_normal(hull, solid, faces, direction_tolerance(grid.spec()));
  const double far = hull_reach(normal, hull);
  const double offset = hull_support(normal, solid) - radius;
  const double most = offset + touching_of(grid, scratch);
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

Status append_obstacles(const Grid& grid, const Hull& hull, const Box& box, double slack, GrowScratch& scratch,
                        Polyhedron& out) {
  const double radius = grid.spec().clearance();
  const int count = extract_local_boxes(grid, voxels_within_reach(grid, box), scratch.extract, scratch.boxes);
  if (count < 0) return Status::kObstaclesFull;
  Status status = Status::kOk;
  for (int i = 0; i < count && status == Status::kOk; ++i) {
    const LocalBox& solid = scratch.boxes[i];
    Vec3 corners[kCorners];
    for (int k = 0; k < kCorners; ++k) {
      corners[k] = {(k & 1) != 0 ? solid.upper[0] : solid.lower[0], (k & 2) != 0 ? solid.upper[1] : solid.lower[1],
                    (k & 4) != 0 ? solid.upper[2] : solid.lower[2]};
    }
    const Hull corner_hull{corners, kCorners};
    if (!is_cut_off(corner_hull, radius, out))
      status = append_between(grid, hull, corner_hull, {nullptr, 0}, slack, scratch, out);
  }
  return status;
}

Status append_fences(const Grid& grid, const Hull& hull, double slack, GrowScratch& scratch, Polyhedron& out) {
  if (scratch.fences == nullptr) return Status::kOk;
  const Fences& fences = *scratch.fences;
  const double radius = grid.spec().clearance();
  for (int k = 0; k < fences.keep_in_count; ++k) {
    if (hull_reach(fences.keep_in[k].normal, hull) > fences.keep_in[k].offset + fences.touching) {
      return Status::kCorridorBlocked;
    }
  }
  Status status = Status::kOk;
  for (int k = 0; k < fences.keep_out_count && status == Status::kOk; ++k) {
    const KeepOut& fence = fences.keep_out[k];
    const Hull solid = hull_of(fences, fence);
    const Faces faces{fences.planes + fence.first_plane, fence.planes};
    if (!is_cut_off(solid, radius, out)) status = append_between(grid, hull, solid, faces, slack, scratch, out);
  }
  return status;
}

}  // namespace

Status enclose_hull(const Grid& grid, const Hull& hull, double slack, GrowScratch& scratch, Polyhedron& out) noexcept {
  out.count = 0;
  out.redundant = 0;
  Box box;
  Status status = append_box(grid, hull, box, scratch, out);
  if (status == Status::kOk) status = append_obstacles(grid, hull, box, slack, scratch, out);
  if (status == Status::kOk) status = append_fences(grid, hull, slack, scratch, out);
  out.from = hull.points[0];
  out.to = hull.points[hull.count - 1];
  out.ellipsoid = Ellipsoid{{{kNoSize, 0.0, 0.0}, {0.0, kNoSize, 0.0}, {0.0, 0.0, kNoSize}}, 0.5 * (out.from + out.to)};
  return status;
}

}  // namespace tern
