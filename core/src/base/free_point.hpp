// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BASE_FREE_POINT_HPP
#define TERN_BASE_FREE_POINT_HPP

#include "base/math.hpp"
#include "tern/grid.hpp"

namespace tern {

/// The point of a free voxel that paths lead through: its centre or, if the centre is outside a thin boundary, the
/// nearest point inside.
inline Vec3 free_point(const Grid& grid, const Voxel& voxel) {
  const Box boundary = grid.local_boundary();
  Vec3 point = grid.center(voxel);
  for (int a = 0; a < 3; ++a) {
    axis(point, a) = clamp(axis(point, a), axis(boundary.lower, a), axis(boundary.upper, a));
  }
  return point;
}

}  // namespace tern

#endif
