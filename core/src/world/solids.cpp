// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/solids.hpp"

namespace tern {

double solid_support(const Vec3& normal, const ConvexSolid& solid) noexcept {
  return hull_support(normal, solid.hull);
}

double solid_reach(const Vec3& normal, const ConvexSolid& solid) noexcept {
  return hull_reach(normal, solid.hull);
}

HullGap solid_gap(const Hull& hull, const ConvexSolid& solid) noexcept {
  return hull_gap(hull, solid.hull);
}

HullGap solid_gap(const Vec3& from, const Vec3& to, const ConvexSolid& solid, double enough) noexcept {
  return widest_gap(from, to, solid.hull, solid.faces, solid.face_count, enough);
}

}  // namespace tern
