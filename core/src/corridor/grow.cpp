// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "corridor/grow.hpp"

#include "base/math.hpp"
#include "corridor/barrier_ellipsoid.hpp"
#include "corridor/ellipsoid_fit.hpp"
#include "corridor/ellipsoid_metric.hpp"
#include "corridor/separation.hpp"

namespace tern {
namespace {

/// A box counts as cut off though rounding says it is not quite, in parts of the coordinates' size.
constexpr double kRounding = 1e-13;

/// Half-spaces of the local box, the first of every polyhedron.
constexpr int kBoxFaces = 6;

/// The barrier's least distance to a plane, in voxels: a hundredth is less than any clearance worth a shape.
constexpr double kLeastSlackCells = 0.01;

/// Least semi-axis of an ellipsoid, in parts of its longest, where a half-space touches the segment.
constexpr double kSliver = 1e-9;

bool cut_off(const Halfspace& plane, const LocalBox& box, double radius) {
  const double beyond = support(plane.normal, box);
  return beyond >= plane.offset + radius - kRounding * (1.0 + absolute(beyond));
}

/// Takes one half-space of the budget and of the polyhedron.
Status append(const Halfspace& plane, GrowScratch& scratch, Polyhedron& out) {
  if (scratch.planes >= scratch.planes_allowed) return Status::kBudgetCorridor;
  if (out.count == kMaxPlanes) return Status::kPlanesFull;
  ++scratch.planes;
  out.planes[out.count++] = plane;
  if (out.count > scratch.planes_high) scratch.planes_high = out.count;
  return Status::kOk;
}

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
  for (int a = 0; a < 3; ++a) {
    Halfspace upper{{0.0, 0.0, 0.0}, axis(box.upper, a)};
    Halfspace lower{{0.0, 0.0, 0.0}, -axis(box.lower, a)};
    axis(upper.normal, a) = 1.0;
    axis(lower.normal, a) = -1.0;
    Status status = append(upper, scratch, out);
    if (status == Status::kOk) status = append(lower, scratch, out);
    if (status != Status::kOk) return status;
  }
  return Status::kOk;
}

/// The boxes that no face cuts off, with where the ellipsoid meets them. Returns how many.
int measure(const EllipsoidMetric& metric, const Obstacles& obstacles, const Polyhedron& out, GrowScratch& scratch) {
  int count = 0;
  for (int i = 0; i < obstacles.count; ++i) {
    bool cut = false;
    for (int p = 0; p < out.count && !cut; ++p) cut = cut_off(out.planes[p], obstacles.boxes[i], obstacles.radius);
    if (cut) continue;
    scratch.scale[i] = contact_of(metric, obstacles.boxes[i], obstacles.radius).scale;
    scratch.remaining[count++] = i;
  }
  return count;
}

/// The remaining box that the ellipsoid meets first; the lower index where two are met at once.
std::int32_t nearest_remaining(const GrowScratch& scratch, int count) {
  std::int32_t nearest = scratch.remaining[0];
  for (int k = 1; k < count; ++k) {
    const std::int32_t i = scratch.remaining[k];
    if (scratch.scale[i] < scratch.scale[nearest]) nearest = i;
  }
  return nearest;
}

/// Keeps the remaining boxes that the half-space does not cut off. `made_for` goes in any case: its own support made
/// the offset.
int drop_cut_off(const Halfspace& plane, const Obstacles& obstacles, std::int32_t made_for, GrowScratch& scratch,
                 int count) {
  int kept = 0;
  for (int k = 0; k < count; ++k) {
    const std::int32_t i = scratch.remaining[k];
    if (i == made_for || cut_off(plane, obstacles.boxes[i], obstacles.radius)) continue;
    scratch.remaining[kept++] = i;
  }
  return kept;
}

/// Step (2) of the section: half-spaces until no box remains. Each pass takes one box at least.
Status append_tangents(const EllipsoidMetric& metric, const Obstacles& obstacles, const SegmentMargin& segment,
                       GrowScratch& scratch, Polyhedron& out) {
  int count = measure(metric, obstacles, out, scratch);
  while (count > 0) {
    const std::int32_t nearest = nearest_remaining(scratch, count);
    const LocalBox& box = obstacles.boxes[nearest];
    const Vec3 tangent = contact_of(metric, box, obstacles.radius).normal;
    Halfspace plane;
    Status status = separate(segment, box, obstacles.radius, tangent, plane);
    if (status == Status::kOk) status = append(plane, scratch, out);
    if (status != Status::kOk) return status;
    count = drop_cut_off(plane, obstacles, nearest, scratch, count);
  }
  return Status::kOk;
}

/// Copies what makes a polyhedron; half-spaces past its count are not worth it.
void copy_planes(const Polyhedron& from, Polyhedron& to) {
  to.count = from.count;
  for (int p = 0; p < from.count; ++p) to.planes[p] = from.planes[p];
}

/// Tries the half-spaces that a larger ellipsoid inside the last polyhedron gives, and keeps the largest polyhedron of
/// all rounds in `out`. A round whose half-spaces do not fit ends the rounds: there is a polyhedron already.
Status improve(const Obstacles& obstacles, const SegmentMargin& segment, double cell, GrowScratch& scratch,
               Polyhedron& out) {
  const double least_slack = kLeastSlackCells * cell;
  BarrierEllipsoid inner = barrier_ellipsoid(out, 0.5 * (segment.from + segment.to), least_slack);
  double largest = inner.size;
  copy_planes(out, scratch.trial);
  for (int round = 0; round < kImprovingRounds; ++round) {
    scratch.trial.count = kBoxFaces;
    const Status status = append_tangents(inner.metric, obstacles, segment, scratch, scratch.trial);
    if (status == Status::kPlanesFull) break;
    if (status != Status::kOk) return status;
    inner = barrier_ellipsoid(scratch.trial, inner.metric.center, least_slack);
    if (inner.size <= largest) continue;
    largest = inner.size;
    copy_planes(scratch.trial, out);
  }
  return Status::kOk;
}

/// Shrinks y and z by one factor until the ellipsoid lies inside every half-space. x stays: every half-space holds the
/// segment, so that there is always such a factor. Where one touches the segment a sliver remains.
void inscribe(const Polyhedron& polyhedron, EllipsoidFrame& frame) {
  double factor = 1.0;
  for (int p = 0; p < polyhedron.count; ++p) {
    const Halfspace& plane = polyhedron.planes[p];
    const double room = plane.offset - dot(plane.normal, frame.center);
    const double x = frame.semi_axis[0] * dot(plane.normal, frame.direction[0]);
    const double y = frame.semi_axis[1] * dot(plane.normal, frame.direction[1]);
    const double z = frame.semi_axis[2] * dot(plane.normal, frame.direction[2]);
    const double across = y * y + z * z;
    const double left = larger(room, 0.0) * room - x * x;
    if (left < factor * factor * across) factor = square_root(larger(left, 0.0) / across);
  }
  frame.semi_axis[1] = larger(frame.semi_axis[1] * factor, kSliver * frame.semi_axis[0]);
  frame.semi_axis[2] = larger(frame.semi_axis[2] * factor, kSliver * frame.semi_axis[0]);
}

/// A hover's ball shrinks as a whole.
void inscribe_ball(const Polyhedron& polyhedron, EllipsoidFrame& frame) {
  double least = frame.semi_axis[0];
  for (int p = 0; p < polyhedron.count; ++p) {
    const Halfspace& plane = polyhedron.planes[p];
    least = smaller(least, plane.offset - dot(plane.normal, frame.center));
  }
  for (double& semi_axis : frame.semi_axis) semi_axis = larger(least, kSliver * semi_axis);
}

/// Fits the ellipsoid, makes the half-spaces, improves them.
Status enclose(const Obstacles& obstacles, const SegmentMargin& segment, double cell, GrowScratch& scratch,
               Polyhedron& out) {
  EllipsoidFrame frame = fit_ellipsoid(segment.from, segment.to, obstacles, cell, scratch.remaining);
  Status status = append_tangents(metric_of(frame), obstacles, segment, scratch, out);
  if (status == Status::kOk) status = improve(obstacles, segment, cell, scratch, out);
  if (status != Status::kOk) return status;
  if (distance(segment.from, segment.to) < kPointLike) {
    inscribe_ball(out, frame);
  } else {
    inscribe(out, frame);
  }
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

  const VoxelRange range = voxels_within_reach(grid, box);
  const int count = extract_local_boxes(grid, range, scratch.extract, scratch.boxes);
  if (count < 0) {
    scratch.boxes_high = kMaxLocalBoxes;
    return Status::kObstaclesFull;
  }
  if (count > scratch.boxes_high) scratch.boxes_high = count;
  return enclose({scratch.boxes, count, spec.radius}, segment, spec.cell, scratch, out);
}

bool within(const Box& boundary, const Vec3& p) {
  for (int a = 0; a < 3; ++a) {
    if (axis(p, a) < axis(boundary.lower, a) - kTouching) return false;
    if (axis(p, a) > axis(boundary.upper, a) + kTouching) return false;
  }
  return true;
}

}  // namespace

void reset_counters(GrowScratch& scratch) noexcept {
  scratch.planes = 0;
  scratch.planes_allowed = 0xFFFFFFFFu;
  scratch.planes_high = 0;
  scratch.boxes_high = 0;
}

Status grow_polyhedron(const Grid& grid, const Vec3& from, const Vec3& to, GrowScratch& scratch,
                       Polyhedron& out) noexcept {
  const Box boundary = grid.local_boundary();
  if (!within(boundary, from) || !within(boundary, to)) return Status::kOutOfMap;
  const double cell = grid.spec().cell;
  const SegmentMargin segment{from, to, kSightMargin * cell};
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
