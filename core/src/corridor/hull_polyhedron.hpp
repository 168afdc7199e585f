// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The polyhedron around a given curve. It encloses the hull of the curve's control points. All other polyhedra of a
// corridor are grown around straight legs.
#ifndef TERN_CORRIDOR_HULL_POLYHEDRON_HPP
#define TERN_CORRIDOR_HULL_POLYHEDRON_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "corridor/grow_scratch.hpp"
#include "tern/corridor.hpp"
#include "tern/grid.hpp"
#include "tern/status.hpp"
#include "world/hull_gap.hpp"
#include "world/world.hpp"

namespace tern {

enum class HullPhase : std::uint8_t { kBox, kExtract, kObstacles, kSolids, kDone };

/// A hull being enclosed. Plain data; needs no initialisation before enclose_begin.
struct HullGrowth {
  Status status;  ///< why it failed; else kOk
  HullPhase phase;
  int next;  ///< the solid to look at next
};

/// Fills `out` with the box around the hull, and adds a half-space for each obstacle and solid that none of the others
/// cuts off by the radius. Local frame. The polyhedron's segment leads from the hull's first point to its last.
///
/// A piece of work is one of extract_advance, or makes the box around the hull, or looks at one solid or all
/// walls. Or it looks at kHullTests obstacle boxes, but at none after the first that needs a half-space.
///
/// kDone: `out` contains the hull, and each obstacle voxel is beyond one half-space by the radius. kFailed, with
/// `status`. kOutOfMap: a point lies outside the boundary. kCorridorBlocked: an obstacle or a solid is closer than
/// the radius, or a point is outside a wall. Also kObstaclesFull and kPlanesFull. `out` is
/// undefined unless kDone.
///
/// `slack`: metres by which the hull may come closer than touching allows. The half-spaces do not move out for it, so
/// points of the hull may lie outside them by that much.
constexpr int kHullTests = 32;
void enclose_begin(HullGrowth& growth) noexcept;
Progress enclose_advance(HullGrowth& growth, const World& world, const Hull& hull, double slack, GrowScratch& scratch,
                         Polyhedron& out, Work& work) noexcept;

/// Encloses the hull in one call. Returns kOk, or why it failed.
Status enclose_hull(const World& world, const Hull& hull, double slack, GrowScratch& scratch, Polyhedron& out) noexcept;

}  // namespace tern

#endif
