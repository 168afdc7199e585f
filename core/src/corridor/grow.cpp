// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "corridor/grow.hpp"

#include "base/math.hpp"
#include "corridor/ellipsoid_fit.hpp"
#include "corridor/ellipsoid_metric.hpp"
#include "corridor/separation.hpp"

namespace tern {
namespace {

/// A box counts as cut off though rounding says it is not quite, in parts of the coordinates' size.
constexpr double kRounding = 1e-13;

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

/// The largest factor, 1 at most, that keeps the ellipsoid inside every half-space.
double inscribed_scale(const EllipsoidMetric& metric, const Polyhedron& polyhedron) {
  double scale = 1.0;
  for (int p = 0; p < polyhedron.count; ++p) {
    const Halfspace& plane = polyhedron.planes[p];
    const double room = larger(plane.offset - dot(plane.normal, metric.center), 0.0);
    const double reach = reach_along(metric, plane.normal);
    if (room < scale * reach) scale = room / reach;
  }
  return scale;
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

  const Obstacles obstacles{scratch.boxes, count, spec.radius};
  const EllipsoidFrame frame = fit_ellipsoid(segment.from, segment.to, obstacles, spec.cell, scratch.remaining);
  const EllipsoidMetric metric = metric_of(frame);
  const Status status = append_tangents(metric, obstacles, segment, scratch, out);
  if (status != Status::kOk) return status;
  out.ellipsoid = ellipsoid_of(frame, inscribed_scale(metric, out));
  out.from = segment.from;
  out.to = segment.to;
  return Status::kOk;
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
