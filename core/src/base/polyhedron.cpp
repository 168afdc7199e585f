// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/polyhedron.hpp"

#include "base/math.hpp"

namespace tern {

void box_planes(const Box& box, Halfspace (&out)[kBoxPlanes]) noexcept {
  for (int a = 0; a < 3; ++a) {
    out[2 * a] = {{0.0, 0.0, 0.0}, axis(box.upper, a)};
    out[2 * a + 1] = {{0.0, 0.0, 0.0}, -axis(box.lower, a)};
    axis(out[2 * a].normal, a) = 1.0;
    axis(out[2 * a + 1].normal, a) = -1.0;
  }
}

bool holds(const Polyhedron& polyhedron, const Vec3& point, double margin) noexcept {
  for (int p = 0; p < polyhedron.count; ++p) {
    const Halfspace& plane = polyhedron.planes[p];
    if (dot(plane.normal, point) > plane.offset - margin) return false;
  }
  return true;
}

double room_at(const Polyhedron& polyhedron, const Vec3& point) noexcept {
  double room = polyhedron.planes[0].offset - dot(polyhedron.planes[0].normal, point);
  for (int p = 1; p < polyhedron.count; ++p) {
    room = smaller(room, polyhedron.planes[p].offset - dot(polyhedron.planes[p].normal, point));
  }
  return room;
}

}  // namespace tern
