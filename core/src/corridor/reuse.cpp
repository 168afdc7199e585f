// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "corridor/reuse.hpp"

#include "base/math.hpp"
#include "ellipsoid/ellipsoid_fit.hpp"
#include "ellipsoid/inscribe.hpp"

namespace tern {

void set_segment(Polyhedron& polyhedron, const Vec3& from, const Vec3& to) noexcept {
  polyhedron.from = from;
  polyhedron.to = to;
  if (distance(from, to) < kPointLike) return;
  EllipsoidFrame frame = sphere_over(from, to);
  inscribe(polyhedron, false, frame);
  polyhedron.ellipsoid = ellipsoid_of(frame);
}

}  // namespace tern
