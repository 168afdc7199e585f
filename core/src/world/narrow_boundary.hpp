// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_WORLD_NARROW_BOUNDARY_HPP
#define TERN_WORLD_NARROW_BOUNDARY_HPP

#include "tern/grid.hpp"
#include "world/solids.hpp"

namespace tern {

/// A wall (local frame, unit normal) as a grid reads the faces of its boundary. If the wall stands across an axis and
/// lies on the lattice up to rounding, it is moved onto the lattice.
Halfspace wall_on_lattice(const GridSpec& spec, const Halfspace& plane) noexcept;

/// The boundary (local frame) within those walls that stand across axis `a`. A wall beyond the opposite face of the
/// boundary counts as on it. Faces that rounding leaves in the wrong order meet.
Box within_walls(const Solids& solids, const Box& boundary, int a) noexcept;

/// Turns walls that are closer together than voxels are wide into a thin boundary (docs/grid.md). If no whole voxel of
/// the boundary lies between the walls across an axis, they become faces of the view's boundary, and `solids` drops
/// them. Some point must obey the walls and the boundary, up to rounding. True if the boundary changed: the view's
/// blocked layer is then that of the old boundary.
bool narrow_boundary(Solids& solids, Grid& view) noexcept;

}  // namespace tern

#endif
