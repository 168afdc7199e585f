// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_CORRIDOR_SOLID_PLANES_HPP
#define TERN_CORRIDOR_SOLID_PLANES_HPP

#include "corridor/grow_scratch.hpp"
#include "corridor/separation.hpp"
#include "tern/corridor.hpp"
#include "tern/status.hpp"
#include "world/world.hpp"

namespace tern {

/// Adds the half-spaces of the world's walls and solids to a polyhedron in `box`; `out` already has the faces of the
/// box. Walls are added as they are, except those that contain the whole box. A solid gets one half-space, unless one
/// in `out` already cuts it off by the clearance. kOk, kCorridorBlocked if the segment itself breaks a wall or a solid,
/// or kPlanesFull.
Status append_solid_planes(const World& world, const Box& box, const SegmentMargin& segment, GrowScratch& scratch,
                           Polyhedron& out) noexcept;

/// True if the whole solid lies beyond one of the polyhedron's bounding half-spaces by at least the radius.
bool is_cut_off(const ConvexSolid& solid, double radius, const Polyhedron& polyhedron) noexcept;

}  // namespace tern

#endif
