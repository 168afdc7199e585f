// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/narrow_boundary.hpp"

#include "base/math.hpp"
#include "grid/lattice.hpp"

namespace tern {
namespace {

/// A unit normal stands across an axis if its components along the other axes are no larger than this. Such components
/// are the rounding of a sine. Over the whole map they move the plane by less than the rounding of its offset does.
constexpr double kAcross = 1e-14;

bool stands_across(const Vec3& normal, int a) {
  for (int other = 0; other < 3; ++other) {
    if (other != a && !(absolute(axis(normal, other)) <= kAcross)) return false;
  }
  return true;
}

/// Drops the walls that stand across axis `a`. False if there are none.
bool drop_walls(Solids& solids, int a) {
  std::int32_t kept = 0;
  for (int p = 0; p < solids.wall_count; ++p) {
    if (stands_across(solids.walls[p].normal, a)) continue;
    solids.wall_index[kept] = solids.wall_index[p];
    solids.walls[kept++] = solids.walls[p];
  }
  const bool any = kept < solids.wall_count;
  solids.wall_count = kept;
  return any;
}

}  // namespace

Halfspace wall_on_lattice(const GridSpec& spec, const Halfspace& plane) noexcept {
  for (int a = 0; a < 3; ++a) {
    if (!stands_across(plane.normal, a)) continue;
    const double sign = axis(plane.normal, a) > 0.0 ? 1.0 : -1.0;
    return {plane.normal, sign * onto_lattice(spec, sign * plane.offset, a)};
  }
  return plane;
}

Box within_walls(const Solids& solids, const Box& boundary, int a) noexcept {
  Box left = boundary;
  double& lower = axis(left.lower, a);
  double& upper = axis(left.upper, a);
  for (int p = 0; p < solids.wall_count; ++p) {
    const Halfspace& plane = solids.walls[p];
    if (!stands_across(plane.normal, a)) continue;
    if (axis(plane.normal, a) > 0.0) upper = larger(smaller(upper, plane.offset), axis(boundary.lower, a));
    if (axis(plane.normal, a) < 0.0) lower = smaller(larger(lower, -plane.offset), axis(boundary.upper, a));
  }
  if (lower > upper) lower = upper = 0.5 * (lower + upper);
  return left;
}

bool narrow_boundary(Solids& solids, Grid& view) noexcept {
  bool narrowed = false;
  for (int a = 0; a < 3; ++a) {
    const Box whole = view.local_boundary();
    GridAccess::set_boundary(view, within_walls(solids, whole, a));
    if (is_thin(view, a) && drop_walls(solids, a)) {
      narrowed = true;
    } else {
      GridAccess::set_boundary(view, whole);
    }
  }
  return narrowed;
}

}  // namespace tern
