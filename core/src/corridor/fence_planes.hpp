// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_CORRIDOR_FENCE_PLANES_HPP
#define TERN_CORRIDOR_FENCE_PLANES_HPP

#include "corridor/grow_scratch.hpp"
#include "corridor/separation.hpp"
#include "tern/corridor.hpp"
#include "tern/status.hpp"

namespace tern {

/// Adds the half-spaces of scratch.fences (null: none) to a polyhedron in `box`; `out` already has the faces of the
/// box. The half-spaces of a keep-in are added as they are, except those that contain the whole box. A keep-out gets
/// one half-space, unless one in `out` already cuts it off by the radius. kOk, kCorridorBlocked if the segment itself
/// breaks a fence, kPlanesFull or kBudgetCorridor.
Status append_fence_planes(const Box& box, const SegmentMargin& segment, double radius, GrowScratch& scratch,
                           Polyhedron& out) noexcept;

/// True if the whole hull lies beyond one of the polyhedron's bounding half-spaces by at least the radius.
bool is_cut_off(const Hull& hull, double radius, const Polyhedron& polyhedron) noexcept;

}  // namespace tern

#endif
