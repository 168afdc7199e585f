// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_CORRIDOR_FENCE_PLANES_HPP
#define TERN_CORRIDOR_FENCE_PLANES_HPP

#include "corridor/grow_scratch.hpp"
#include "corridor/separation.hpp"
#include "tern/corridor.hpp"
#include "tern/status.hpp"

namespace tern {

/// Adds the half-spaces that scratch.fences (null: none) ask for of a polyhedron in `box`, whose faces `out` holds
/// already: those of keep-ins that the box does not keep by itself, just as they are, and one for each keep-out that is
/// nearer to the polyhedron than the radius. kOk, kCorridorBlocked where the segment itself breaks one, kPlanesFull or
/// kBudgetCorridor.
Status append_fence_planes(const Box& box, const SegmentMargin& segment, double radius, GrowScratch& scratch,
                           Polyhedron& out) noexcept;

/// True where some half-space that bounds the polyhedron has all of the hull beyond it by the radius.
bool is_cut_off(const Hull& hull, double radius, const Polyhedron& polyhedron) noexcept;

}  // namespace tern

#endif
