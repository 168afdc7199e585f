// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "corridor/fence_planes.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

/// max of normal . p over the box.
double reach_of(const Box& box, const Vec3& normal) {
  const double x = normal.x * (normal.x < 0.0 ? box.lower.x : box.upper.x);
  const double y = normal.y * (normal.y < 0.0 ? box.lower.y : box.upper.y);
  const double z = normal.z * (normal.z < 0.0 ? box.lower.z : box.upper.z);
  return (x + y) + z;
}

/// Adds the half-space of a keep-in as it is. If the segment lies outside by no more than rounding, the half-space
/// moves out to contain it.
Status append_keep_in(const Halfspace& fence, const SegmentMargin& segment, GrowScratch& scratch, Polyhedron& out) {
  const double far = larger(dot(fence.normal, segment.from), dot(fence.normal, segment.to));
  if (far > fence.offset + segment.touching) return Status::kCorridorBlocked;
  return append({fence.normal, larger(fence.offset, far)}, scratch, out);
}

}  // namespace

bool is_cut_off(const Hull& hull, double radius, const Polyhedron& polyhedron) noexcept {
  for (int p = 0; p < polyhedron.count; ++p) {
    const Halfspace& plane = polyhedron.planes[p];
    if (hull_support(plane.normal, hull) >= plane.offset + radius) return true;
  }
  return false;
}

Status append_fence_planes(const Box& box, const SegmentMargin& segment, double radius, GrowScratch& scratch,
                           Polyhedron& out) noexcept {
  if (scratch.fences == nullptr) return Status::kOk;
  const Fences& fences = *scratch.fences;
  Status status = Status::kOk;
  for (int k = 0; k < fences.keep_in_count && status == Status::kOk; ++k) {
    const Halfspace& fence = fences.keep_in[k];
    if (reach_of(box, fence.normal) > fence.offset) status = append_keep_in(fence, segment, scratch, out);
  }
  for (int k = 0; k < fences.keep_out_count && status == Status::kOk; ++k) {
    const KeepOut& fence = fences.keep_out[k];
    const Hull hull = hull_of(fences, fence);
    if (is_cut_off(hull, radius, out)) continue;
    Halfspace plane;
    status = separate(segment, hull, fences.planes + fence.first_plane, fence.planes, radius, plane);
    if (status == Status::kOk) status = append(plane, scratch, out);
  }
  return status;
}

}  // namespace tern
