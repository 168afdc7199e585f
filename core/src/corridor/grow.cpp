// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "corridor/grow.hpp"

#include "base/math.hpp"
#include "base/polyhedron.hpp"
#include "corridor/fence_planes.hpp"
#include "corridor/improve.hpp"
#include "corridor/redundancy.hpp"
#include "corridor/separation.hpp"
#include "corridor/tangent_planes.hpp"
#include "ellipsoid/ellipsoid_fit.hpp"
#include "ellipsoid/inscribe.hpp"
#include "grid/distance.hpp"
#include "tern/fence.hpp"

namespace tern {
namespace {

/// Least semi-axis of the ellipsoid that the first half-spaces are tangent to, as a share of the segment's half length.
constexpr double kThickness = 0.3;

/// The least distance to a plane that the barrier uses, in voxels. It is less than half the width of a tunnel, so it
/// blurs no shape.
constexpr double kLeastSlackCells = 0.1;

/// The box around the segment that the polyhedron stays in.
Box local_box(const Grid& grid, const Vec3& from, const Vec3& to, double margin) {
  const Box boundary = grid.local_boundary();
  Box box;
  for (int a = 0; a < 3; ++a) {
    const double low = smaller(axis(from, a), axis(to, a));
    const double high = larger(axis(from, a), axis(to, a));
    axis(box.lower, a) = larger(low - margin, axis(boundary.lower, a));
    axis(box.upper, a) = smaller(high + margin, axis(boundary.upper, a));
  }
  return box;
}

Status append_faces(const Box& box, GrowScratch& scratch, Polyhedron& out) {
  Halfspace faces[kBoxPlanes];
  box_planes(box, faces);
  Status status = Status::kOk;
  for (int k = 0; k < kBoxPlanes && status == Status::kOk; ++k) status = append(faces[k], scratch, out);
  return status;
}

/// The diagonal of the local box, computed from the first six half-spaces.
double box_diagonal(const Polyhedron& polyhedron) {
  const Halfspace* faces = polyhedron.planes;
  const Vec3 extent{faces[0].offset + faces[1].offset, faces[2].offset + faces[3].offset,
                    faces[4].offset + faces[5].offset};
  return length(extent);
}

/// The analytic centre or the segment's middle, whichever is deeper inside. The centre may lie outside if the
/// polyhedron is thinner than the barrier's least slack. The middle may lie on a plane that the segment touches.
Vec3 inner_point(const Polyhedron& polyhedron, const Vec3& center, const SegmentMargin& segment) {
  const Vec3 middle = 0.5 * (segment.from + segment.to);
  return room_at(polyhedron, center) < room_at(polyhedron, middle) ? middle : center;
}

/// Fits the ellipsoid between the obstacles in scratch.boxes, makes half-spaces for those that the given ones leave,
/// and improves them.
Status enclose(int count, const SegmentMargin& segment, const GridSpec& spec, GrowScratch& scratch, Polyhedron& out) {
  const int given = out.count;
  const double cell = spec.cell;
  EllipsoidFrame frame =
      fit_ellipsoid(segment.from, segment.to, {scratch.boxes, count, spec.clearance()}, cell, scratch.remaining);
  const Obstacles obstacles{scratch.boxes, keep_uncut(out, spec.clearance(), scratch.boxes, count), spec.clearance()};
  const EllipsoidMetric metric = metric_of(at_least_as_thick(frame, kThickness));
  Status status = append_tangents(metric, obstacles, segment, scratch, out);
  Vec3 center;
  if (status == Status::kOk) {
    status = improve({obstacles, segment, kLeastSlackCells * cell, given}, scratch, out, center);
  }
  if (status != Status::kOk) return status;
  set_redundant_aside(out, inner_point(out, center, segment), box_diagonal(out), scratch.trial.planes);
  inscribe(out, distance(segment.from, segment.to) < kPointLike, frame);
  out.ellipsoid = ellipsoid_of(frame);
  out.from = segment.from;
  out.to = segment.to;
  return Status::kOk;
}

Status grow_in_box(const Grid& grid, const SegmentMargin& segment, double reach, GrowScratch& scratch,
                   Polyhedron& out) {
  const GridSpec& spec = grid.spec();
  const Box box = local_box(grid, segment.from, segment.to, reach);
  out.count = 0;
  const Status faces = append_faces(box, scratch, out);
  if (faces != Status::kOk) return faces;
  const Status fences = append_fence_planes(box, segment, spec.clearance(), scratch, out);
  if (fences != Status::kOk) return fences;

  const VoxelRange range = voxels_within_reach(grid, box);
  const int count = extract_local_boxes(grid, range, scratch.extract, scratch.boxes);
  if (count < 0) {
    scratch.boxes_high = kMaxLocalBoxes;
    return Status::kObstaclesFull;
  }
  if (count > scratch.boxes_high) scratch.boxes_high = count;
  return enclose(count, segment, spec, scratch, out);
}

bool within(const Box& boundary, const Vec3& p, double tolerance) {
  for (int a = 0; a < 3; ++a) {
    if (axis(p, a) < axis(boundary.lower, a) - tolerance) return false;
    if (axis(p, a) > axis(boundary.upper, a) + tolerance) return false;
  }
  return true;
}

}  // namespace

Status grow_polyhedron(const Grid& grid, const Vec3& from, const Vec3& to, GrowScratch& scratch,
                       Polyhedron& out) noexcept {
  const Box boundary = grid.local_boundary();
  const double touching = touching_of(grid, scratch);
  if (!within(boundary, from, touching) || !within(boundary, to, touching)) return Status::kOutOfMap;
  const double cell = grid.spec().cell;
  const SegmentMargin segment{from, to, kSightMargin * cell, touching, direction_tolerance(grid.spec())};
  double reach = larger(kLocalMargin, kLocalMarginCells * cell);
  Status status = Status::kPlanesFull;
  for (int level = 0; level < kBoxLevels; ++level) {
    status = grow_in_box(grid, segment, reach, scratch, out);
    if (status != Status::kPlanesFull && status != Status::kObstaclesFull) break;
    reach *= 0.5;
  }
  return status;
}

}  // namespace tern
