// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "corridor/solid_planes.hpp"

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

/// Adds a wall as it is. If the segment lies outside by no more than rounding, the half-space moves out to contain it.
Status append_wall(const Halfspace& wall, const SegmentMargin& segment, GrowScratch& scratch, Polyhedron& out) {
  const double far = larger(dot(wall.normal, segment.from), dot(wall.normal, segment.to));
  if (far > wall.offset + segment.touching) return Status::kCorridorBlocked;
  return append({wall.normal, larger(wall.offset, far)}, scratch, out);
}

}  // namespace

bool is_cut_off(const ConvexSolid& solid, double radius, const Polyhedron& polyhedron) noexcept {
  for (int p = 0; p < polyhedron.count; ++p) {
    const Halfspace& plane = polyhedron.planes[p];
    if (solid_support(plane.normal, solid) >= plane.offset + radius) return true;
  }
  return false;
}

Status append_solid_planes(const World& world, const Box& box, const SegmentMargin& segment, GrowScratch& scratch,
                           Polyhedron& out) noexcept {
  Status status = Status::kOk;
  for (int k = 0; k < world.wall_count() && status == Status::kOk; ++k) {
    const Halfspace& wall = world.wall(k);
    if (reach_of(box, wall.normal) > wall.offset) status = append_wall(wall, segment, scratch, out);
  }
  const double radius = world.spec().clearance();
  for (int k = 0; k < world.solid_count() && status == Status::kOk; ++k) {
    const ConvexSolid solid = world.solid(k);
    if (is_cut_off(solid, radius, out)) continue;
    Halfspace plane;
    status = separate(segment, solid, radius, plane);
    if (status == Status::kOk) status = append(plane, scratch, out);
  }
  return status;
}

}  // namespace tern
