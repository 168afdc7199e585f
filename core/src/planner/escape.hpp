// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What remains for an end that moves where neither the corridor nor a detour has room for its motion: come to rest
// first, in any way there is room for (curve/stopping.hpp), and fly from there. A goal's escape is flown backwards
// in time, to where the motion can have begun.
#ifndef TERN_PLANNER_ESCAPE_HPP
#define TERN_PLANNER_ESCAPE_HPP

#include <cstdint>

#include "base/bounds.hpp"
#include "corridor/grow_scratch.hpp"
#include "curve/stopping.hpp"
#include "planner/tube.hpp"
#include "tern/corridor.hpp"
#include "tern/grid.hpp"
#include "tern/request.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// Report::detours of a plan that took one.
constexpr std::int32_t kEscaped = 2;

/// Segments of one choice at most.
constexpr int kEscapeSegments = kMaxSegments < 16 ? kMaxSegments : 16;

/// Half-spaces that one choice makes at most: each segment is the last half of one that had no room.
constexpr std::uint32_t kEscapePlanes = 2u * kEscapeSegments * static_cast<std::uint32_t>(kMaxPlanes);

/// One end's way to rest, each segment in a polyhedron of its own: a choice, or the rest of the previous plan.
struct Escape {
  int next;           ///< choice to be tried next, 0 .. kStoppingChoices
  int count;          ///< segments; 0 while there is no way
  Stopping stopping;  ///< the choice at hand
  Vec3 rest;          ///< where the motion ends (a goal's: begins), relative to the plan's origin
  Segment segments[kMaxSegments];
  Polyhedron polyhedra[kMaxSegments];
};

/// An empty tube over the escape's own arrays.
inline Tube tube_of(Escape& escape, int capacity) noexcept {
  return {escape.segments, escape.polyhedra, capacity, 0, 0.0};
}

/// Where a stop is flown.
struct EscapeRoom {
  const Grid& grid;
  Vec3 origin;   ///< of the plan's frame, in the grid's local frame
  bool to_goal;  ///< the state is the goal's
};

/// Tries the next choice for `state` (relative to the plan's origin). True where it has room: fills the escape.
bool escape_try(const EscapeRoom& room, const State& state, const MotionLimits& limits, GrowScratch& scratch,
                Escape& escape) noexcept;

/// Choices of the duration of an arrival.
constexpr int kArrivals = 12;

/// Tries to fly from the start straight into the motion of the goal with one curve, `choice` of 0 .. kArrivals - 1:
/// what is left of a plan that is nearly flown, where there is no room to stop before the goal any more. Fills the
/// escape.
bool arrive_try(const EscapeRoom& room, const State& start, const State& goal, const MotionLimits& limits, int choice,
                GrowScratch& scratch, Escape& escape) noexcept;

/// Puts the start's escape before a plan and the goal's behind it; either may be empty. False, with nothing changed,
/// where there is no capacity for all segments or polyhedra.
bool add_escapes(const Escape& start, const Escape& goal, Corridor& corridor, Trajectory& trajectory) noexcept;

}  // namespace tern

#endif
