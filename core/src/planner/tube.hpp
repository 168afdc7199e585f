// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A corridor made for curves that are given: each segment in a polyhedron of its own around the hull of its control
// points.
#ifndef TERN_PLANNER_TUBE_HPP
#define TERN_PLANNER_TUBE_HPP

#include "corridor/grow_scratch.hpp"
#include "tern/corridor.hpp"
#include "tern/grid.hpp"
#include "tern/status.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// A segment whose hull has no room is halved, and each half again: a hull's excess over its curve shrinks fourfold.
constexpr int kTubeHalvings = 6;

/// Segments and their polyhedra, index by index; the arrays are the caller's.
struct Tube {
  Segment* segments;
  Polyhedron* polyhedra;
  int capacity;
  int count;
  double slack;  ///< see enclose_hull
};

/// Appends the segment (relative to `origin`, a point of the grid's local frame): as a whole where its hull keeps clear
/// of everything, else in halves, and so on. kCorridorBlocked where no such parts are found, kSegmentsFull where the
/// tube has no room for them; it then holds what fitted.
Status enclose(const Grid& grid, const Vec3& origin, const Segment& whole, GrowScratch& scratch, Tube& tube) noexcept;

}  // namespace tern

#endif
