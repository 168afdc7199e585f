// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A corridor around given curves. Each segment gets its own polyhedron, around the hull of its control points.
#ifndef TERN_PLANNER_TUBE_HPP
#define TERN_PLANNER_TUBE_HPP

#include "base/progress.hpp"
#include "base/work.hpp"
#include "corridor/grow_scratch.hpp"
#include "corridor/hull_polyhedron.hpp"
#include "tern/corridor.hpp"
#include "tern/grid.hpp"
#include "tern/status.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// The most times that a segment whose hull has no room is halved. Each halving makes the excess of the hull over the
/// curve four times smaller.
constexpr int kTubeHalvings = 6;

/// Segments and their polyhedra, index by index; the arrays are the caller's.
struct Tube {
  Segment* segments;
  Polyhedron* polyhedra;
  int capacity;
  int count;
  double slack;  ///< see enclose_advance
};

/// A segment being appended. Plain data; needs no initialisation before append_begin.
struct SegmentEnclosure {
  Status status;  ///< why it failed; else kOk
  int pending;    ///< parts that wait for a polyhedron, the next one last
  Segment segment[kTubeHalvings + 1];
  int halvings[kTubeHalvings + 1];
  HullGrowth growth;  ///< of the next part's polyhedron
};

/// Appends a segment, which is relative to `origin`, a point of the grid's local frame. Appends the whole segment if
/// its hull keeps clear of everything; otherwise its halves, and so on. A unit of work is one of enclose_advance.
/// kFailed: kCorridorBlocked if even the smallest parts do not keep clear; kSegmentsFull if the tube has too little
/// room for the parts. It then contains the parts that fitted.
void append_begin(SegmentEnclosure& enclosure, const Segment& whole) noexcept;
Progress append_advance(SegmentEnclosure& enclosure, const World& world, const Vec3& origin, GrowScratch& scratch,
                        Tube& tube, Work& work) noexcept;

/// Appends a segment in one call. Returns kOk, or why it failed.
Status enclose(const World& world, const Vec3& origin, const Segment& whole, GrowScratch& scratch, Tube& tube) noexcept;

}  // namespace tern

#endif
