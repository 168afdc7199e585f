// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The polyhedron of a curve that is given: around the hull of its control points, where the corridor's others are grown
// around straight legs.
#ifndef TERN_CORRIDOR_HULL_POLYHEDRON_HPP
#define TERN_CORRIDOR_HULL_POLYHEDRON_HPP

#include "corridor/grow_scratch.hpp"
#include "grid/hull_gap.hpp"
#include "tern/corridor.hpp"
#include "tern/grid.hpp"
#include "tern/status.hpp"

namespace tern {

/// Fills `out` with the box around the hull and a half-space for each obstacle and keep-out that the others leave
/// within the radius. Local frame; scratch.fences as in grow_polyhedron. The polyhedron's segment leads from the hull's
/// first point to its last; its ellipsoid is a ball around the middle of the two.
///
/// kOk: `out` holds the hull, and each obstacle voxel is beyond one half-space by the radius. kOutOfMap: a point beyond
/// the boundary. kCorridorBlocked: an obstacle, a keep-out or a keep-in's face nearer than it may be. kObstaclesFull,
/// kPlanesFull, kBudgetCorridor. `out` is undefined after anything but kOk.
///
/// `slack`: metres by which the hull may come nearer than it may touch. Its points then lie as far outside the
/// half-spaces, which are what touching allows.
Status enclose_hull(const Grid& grid, const Hull& hull, double slack, GrowScratch& scratch, Polyhedron& out) noexcept;

}  // namespace tern

#endif
