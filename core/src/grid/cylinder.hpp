// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The voxels that an upright cylinder meets, row by row.
#ifndef TERN_GRID_CYLINDER_HPP
#define TERN_GRID_CYLINDER_HPP

#include <cstdint>

#include "base/math.hpp"
#include "grid/lattice.hpp"
#include "tern/grid.hpp"

namespace tern {

inline Status check(const Cylinder& cylinder) {
  const bool is_finite = finite(cylinder.base) && finite(cylinder.radius) && finite(cylinder.height);
  if (!is_finite) return Status::kNonFiniteInput;
  return cylinder.radius >= 0.0 && cylinder.height >= 0.0 ? Status::kOk : Status::kInvalidArgument;
}

/// The planes that the cylinder meets.
inline IndexRange planes_met(const GridSpec& spec, const Cylinder& cylinder) {
  return voxels_met(spec, cylinder.base.z, cylinder.base.z + cylinder.height, 2);
}

/// Calls visit(y, x) for each row that the cylinder meets in a plane; x is the range of the row's voxels. All planes
/// have the same rows. The range is as wide as the disc at the row's point nearest to the axis.
template <typename Visit>
void visit_rows(const GridSpec& spec, const Cylinder& cylinder, Visit visit) {
  const Vec3& base = cylinder.base;
  const double radius = cylinder.radius;
  const IndexRange rows = voxels_met(spec, base.y - radius, base.y + radius, 1);
  for (std::int32_t y = rows.begin; y < rows.end; ++y) {
    const double lower = spec.origin.y + spec.cell * y;
    const double off = clamp(base.y, lower, lower + spec.cell) - base.y;
    const double rest = radius * radius - off * off;
    const double half = rest > 0.0 ? square_root(rest) : 0.0;
    const IndexRange x = voxels_met(spec, base.x - half, base.x + half, 0);
    if (x.begin < x.end) visit(y, x);
  }
}

}  // namespace tern

#endif
