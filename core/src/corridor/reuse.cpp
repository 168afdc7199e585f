// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "corridor/reuse.hpp"

#include "base/math.hpp"
#include "corridor/ellipsoid_fit.hpp"
#include "corridor/inscribe.hpp"

namespace tern {

bool holds(const Polyhedron& polyhedron, const Vec3& point, double margin) noexcept {
  for (int p = 0; p < polyhedron.count; ++p) {
    const Halfspace& plane = polyhedron.planes[p];
    if (dot(plane.normal, point) > plane.offset - margin) return false;
  }
  return true;
}

void extend_segment(Polyhedron& polyhedron, const Vec3& point) noexcept {
  polyhedron.to = point;
  // Back to where it began, or from hover to hover: the ellipsoid stays, which lies inside as it is.
  const bool is_point = distance(polyhedron.from, point) < kPointLike;
  if (is_point) return;
  EllipsoidFrame frame = sphere_over(polyhedron.from, point);
  inscribe(polyhedron, false, frame);
  polyhedron.ellipsoid = ellipsoid_of(frame);
}

}  // namespace tern
