// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PATH_SIGHT_HPP
#define TERN_PATH_SIGHT_HPP

#include <cstdint>

#include "base/math.hpp"
#include "base/work.hpp"
#include "tern/grid.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Sight is stricter than its margin by this share of a voxel. That outweighs every rounding error of the walk, so
/// whatever counts as visible really is.
constexpr double kSightRounding = 1e-9;

/// The supercover line of sight, thickened. True only if all voxels near the segment from a to b are free and lie in
/// the grid. "Near" means that the closed cube comes within `margin` (in voxels, max norm, 0 .. 0.5) of the segment.
/// Local frame. The ends may lie anywhere in the grid and may be equal. Reads the words of each row of voxels that the
/// thick segment meets.
bool line_of_sight(const Grid& grid, const Vec3& a, const Vec3& b, double margin = kSightMargin) noexcept;

/// Operations of a line of sight, which reads a word or two of each row along x that the line meets.
inline Operations sight_operations(const Grid& grid, const Vec3& a, const Vec3& b) noexcept {
  const GridSpec& spec = grid.spec();
  const double across = (absolute(b.y - a.y) + absolute(b.z - a.z)) / spec.cell;
  return ops::kPiece + 2 * ops::kTurn * static_cast<Operations>(smaller(across, spec.dims.y + spec.dims.z));
}

}  // namespace tern

#endif
