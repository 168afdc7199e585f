// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "corridor/redundancy.hpp"

#include "base/math.hpp"
#include "world/facet.hpp"

namespace tern {
namespace {

/// The half-spaces relative to a point inside, so that the result does not depend on where the map is. `redundant`
/// marks those found to be redundant so far.
struct Planes {
  Halfspace* at;
  int count;
  bool redundant[kMaxPlanes];
};

/// False if the point lies on a plane, or within `thickness` of it.
bool move_to(const Vec3& inside, double thickness, const Polyhedron& polyhedron, Planes& planes) {
  for (int p = 0; p < planes.count; ++p) {
    const Halfspace& plane = polyhedron.planes[p];
    planes.at[p] = {plane.normal, plane.offset - dot(plane.normal, inside)};
    planes.redundant[p] = false;
    if (planes.at[p].offset <= thickness) return false;
  }
  return true;
}

/// True if the other half-spaces leave nothing of this plane after it has moved out by `thickness`: the polyhedron
/// without this half-space then reaches no further than that.
bool is_redundant(const Planes& planes, int index, double reach, double thickness, int& cuts) {
  const Halfspace& plane = planes.at[index];
  if (plane.offset >= reach) return true;
  Facet facet = square_on({plane.normal, plane.offset + thickness}, reach);
  for (int p = 0; p < planes.count; ++p) {
    if (p == index || planes.redundant[p]) continue;
    ++cuts;
    if (!cut(planes.at[p], facet)) return true;
  }
  return false;
}

}  // namespace

int drop_redundant(Polyhedron& polyhedron, const Vec3& inside, double reach, Halfspace* scratch) noexcept {
  const double thickness = kSliverThickness * reach;
  Planes planes;
  planes.at = scratch;
  planes.count = polyhedron.count;
  if (!move_to(inside, thickness, polyhedron, planes)) return 0;
  int kept = 0;
  int cuts = 0;
  for (int p = 0; p < planes.count; ++p) {
    planes.redundant[p] = is_redundant(planes, p, reach, thickness, cuts);
    if (!planes.redundant[p]) polyhedron.planes[kept++] = polyhedron.planes[p];
  }
  polyhedron.count = kept;
  return cuts;
}

}  // namespace tern
