// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PATH_SIGHT_HPP
#define TERN_PATH_SIGHT_HPP

#include "tern/grid.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Part of a voxel by which sight is stricter than kSightMargin says: outweighs every rounding error of the walk, so
/// that what counts as visible is.
constexpr double kSightRounding = 1e-9;

/// The supercover line of sight, thickened: true only where every voxel whose closed cube comes within `margin` of a
/// voxel (max norm, 0 .. 0.5) of the segment from a to b is free, and all of that lies in the grid. Local frame; ends
/// anywhere in the grid, equal ends too. Reads the words of each row of voxels that the thick segment meets.
bool line_of_sight(const Grid& grid, const Vec3& a, const Vec3& b, double margin = kSightMargin) noexcept;

}  // namespace tern

#endif
