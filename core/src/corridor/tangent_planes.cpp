// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "corridor/tangent_planes.hpp"

#include "base/linear.hpp"
#include "grid/touching.hpp"

namespace tern {
namespace {

/// A box counts as cut off even if it falls short by this much, relative to the size of its coordinates. Otherwise
/// rounding would give each box of a row along one face a half-space of its own.
constexpr double kRounding = 1e-15;

bool cut_off(const Halfspace& plane, const LocalBox& box, double radius) {
  const double short_of = plane.offset + radius - support(plane.normal, box_of(box));
  if (short_of <= 0.0) return true;
  // Local coordinates are not negative, except at boundaries on the grid's own edge, so their sum measures their size.
  return short_of <= kRounding * (1.0 + ((box.upper[0] + box.upper[1]) + box.upper[2]));
}

/// Lists the boxes that no half-space cuts off yet, with the scale at which the ellipsoid meets each. Returns how many.
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

/// The remaining box that the growing ellipsoid meets first; of two met at once, the one with the lower index.
std::int32_t nearest_remaining(const GrowScratch& scratch, int count) {
  std::int32_t nearest = scratch.remaining[0];
  for (int k = 1; k < count; ++k) {
    const std::int32_t i = scratch.remaining[k];
    if (scratch.scale[i] < scratch.scale[nearest]) nearest = i;
  }
  return nearest;
}

/// Keeps the remaining boxes that the half-space does not cut off. The box `made_for` is always dropped, because the
/// offset was computed from it.
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

}  // namespace

Status append_tangents(const EllipsoidMetric& metric, const Obstacles& obstacles, const SegmentMargin& segment,
                       GrowScratch& scratch, Polyhedron& out) noexcept {
  int count = measure(metric, obstacles, out, scratch);
  while (count > 0) {
    const std::int32_t nearest = nearest_remaining(scratch, count);
    const LocalBox& box = obstacles.boxes[nearest];
    const Vec3 tangent = to_vec3(contact_of(metric, box, obstacles.radius).normal);
    Halfspace plane;
    Status status = separate(segment, box, obstacles.radius, tangent, plane);
    if (status == Status::kOk) status = append(plane, scratch, out);
    if (status != Status::kOk) return status;
    count = drop_cut_off(plane, obstacles, nearest, scratch, count);
  }
  return Status::kOk;
}

}  // namespace tern
