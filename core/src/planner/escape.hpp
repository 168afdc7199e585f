// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The last resort for an end in motion, if neither the corridor nor a detour has room for the motion: come to rest
// first, by any manoeuvre that has room (curve/stopping.hpp), and fly from there. The escape of a goal is computed
// backwards in time, to a place where its motion can have begun.
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

/// Diagnostics::detours of a plan with an escape or an arrival.
constexpr std::int32_t kEscaped = 2;

/// The most segments of one choice.
constexpr int kEscapeSegments = kMaxSegments < 16 ? kMaxSegments : 16;

/// The most half-spaces that one choice makes. The factor 2 is for segments that had no room and were halved.
constexpr std::uint32_t kEscapePlanes = 2u * kEscapeSegments * static_cast<std::uint32_t>(kMaxPlanes);

/// The motion of one end to rest, with a polyhedron for each segment. It is one of the choices, or the rest of the
/// previous plan.
struct Escape {
  int next;             ///< choice to be tried next, 0 .. kStoppingChoices
  int count;            ///< segments; 0 if there is no motion yet
  bool trying;          ///< the choice before `next` is being tried
  int enclosed;         ///< parts of this choice that have a polyhedron, halves included
  int appended;         ///< segments of this choice that are enclosed
  Appending appending;  ///< the segment that is being enclosed
  Stopping stopping;    ///< the current choice
  Vec3 rest;            ///< where the motion ends (for a goal: begins), relative to the plan's origin
  Segment segments[kMaxSegments];
  Polyhedron polyhedra[kMaxSegments];
};

/// An empty tube over the escape's own arrays.
inline Tube tube_of(Escape& escape, int capacity) noexcept {
  return {escape.segments, escape.polyhedra, capacity, 0, 0.0};
}

/// The world and the frame that a stop is flown in, and the end that it is for.
struct EscapeRoom {
  World world;
  Vec3 origin;   ///< of the plan's frame, in the grid's local frame
  bool to_goal;  ///< the state is the goal's
};

/// Tries the next choice for `state` (relative to the plan's origin). One unit of work makes the stop; the others are
/// those of append_advance. kDone: the stop has room, and the escape is filled in. kFailed: the stop has no room.
Progress escape_advance(const EscapeRoom& room, const State& state, const MotionLimits& limits, GrowScratch& scratch,
                        Escape& escape, Work& work) noexcept;

/// Durations that an arrival tries.
constexpr int kArrivals = 12;

/// Tries an arrival: one curve from the start straight into the motion of the goal, with duration number `choice`, 0 ..
/// kArrivals - 1. This helps near the end of a flight, when there is no room left to stop before the goal. Its units
/// and answers are those of escape_advance.
Progress arrive_advance(const EscapeRoom& room, const State& start, const State& goal, const MotionLimits& limits,
                        int choice, GrowScratch& scratch, Escape& escape, Work& work) noexcept;

/// Puts the start's escape before a plan and the goal's behind it; either may be empty. False, with nothing changed, if
/// there is no capacity for all segments or polyhedra.
bool add_escapes(const Escape& start, const Escape& goal, Corridor& corridor, Trajectory& trajectory) noexcept;

}  // namespace tern

#endif
