// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/relative_corridor.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

Halfspace relative_plane(const Halfspace& plane, const Vec3& origin, const Vec3& from, const Vec3& to) {
  const double offset = plane.offset - dot(plane.normal, origin);
  const double far = larger(dot(plane.normal, from), dot(plane.normal, to));
  return {plane.normal, larger(far, offset - kCorridorReserve)};
}

/// Puts the ends of polyhedra that meet at a via at its position.
void set_joints(const ViaJoints& via_joints, Corridor& out) {
  for (int i = 0; i < via_joints.count; ++i) {
    const int after = via_joints.list[i].polyhedron;
    out.polyhedra[after - 1].to = via_joints.list[i].position;
    out.polyhedra[after].from = via_joints.list[i].position;
  }
}

void set_planes(const Polyhedron& in, const Vec3& origin, Polyhedron& relative) {
  for (int p = 0; p < in.count; ++p) {
    relative.planes[p] = relative_plane(in.planes[p], origin, relative.from, relative.to);
  }
}

}  // namespace

void relative_corridor(const Corridor& corridor, const Vec3& origin, const Vec3& start, const Vec3& goal,
                       const ViaJoints& via_joints, Corridor& out) noexcept {
  out.count = corridor.count;
  for (int i = 0; i < corridor.count; ++i) {
    const Polyhedron& in = corridor.polyhedra[i];
    Polyhedron& relative = out.polyhedra[i];
    relative.count = in.count;
    relative.from = i == 0 ? start : in.from - origin;
    relative.to = i + 1 == corridor.count ? goal : in.to - origin;
  }
  set_joints(via_joints, out);
  for (int i = 0; i < corridor.count; ++i) set_planes(corridor.polyhedra[i], origin, out.polyhedra[i]);
}

}  // namespace tern
