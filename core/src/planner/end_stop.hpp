// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stop at one end of a plan that is in motion, by any manoeuvre that has room (curve/stopping.hpp). The stop of a
// goal is computed backwards in time, to a place where its motion can have begun.
#ifndef TERN_PLANNER_END_STOP_HPP
#define TERN_PLANNER_END_STOP_HPP

#include <cstdint>

#include "base/bounds.hpp"
#include "corridor/grow_scratch.hpp"
#include "curve/stopping.hpp"
#include "planner/tube.hpp"
#include "tern/corridor.hpp"
#include "tern/request.hpp"
#include "tern/trajectory.hpp"
#include "world/world.hpp"

namespace tern {

/// The most segments of one choice.
constexpr int kStopSegments = kMaxSegments < 16 ? kMaxSegments : 16;

/// The motion of one end to rest, with a polyhedron for each segment. It is one of the choices, or the remainder of the
/// previous plan.
struct EndStop {
  int next_choice;             ///< to be tried next, 0 .. kStoppingChoices
  int count;                   ///< segments; 0 if there is no motion yet
  bool is_tried;               ///< the choice before `next_choice` is being tried
  int enclosed;                ///< parts of this choice that have a polyhedron, halves included
  int appended;                ///< segments of this choice that are enclosed
  SegmentEnclosure enclosure;  ///< the segment that is being enclosed
  Stopping stopping;           ///< the current choice
  Vec3 place;                  ///< where the motion ends (for a goal: begins), relative to the plan's origin
  Segment segments[kMaxSegments];
  Polyhedron polyhedra[kMaxSegments];
};

/// No choice is tried yet.
inline void reset(EndStop& stop) noexcept {
  stop.next_choice = stop.count = 0;
  stop.is_tried = false;
}

/// An empty tube over the stop's own arrays.
inline Tube tube_of(EndStop& stop, int capacity) noexcept {
  return {stop.segments, stop.polyhedra, capacity, 0, 0.0};
}

/// The world and the frame that a stop is flown in, and the end that it is for.
struct StopContext {
  World world;
  Vec3 origin;   ///< of the plan's frame, in the grid's local frame
  bool to_goal;  ///< the state is the goal's
};

/// Tries the next choice for `state` (relative to the plan's origin). One unit of work makes the stop; the others are
/// those of append_advance. kDone: the stop has room and is filled in. kFailed: it has no room.
Progress stop_advance(const StopContext& context, const State& state, const MotionLimits& limits, GrowScratch& scratch,
                      EndStop& stop, Work& work) noexcept;

/// Durations that an arrival tries.
constexpr int kArrivals = 12;

/// Tries an arrival: one curve from the start straight into the motion of the goal, with duration number `choice`, 0 ..
/// kArrivals - 1. This helps near the end of a flight, when there is no room left to stop before the goal. Its units
/// and answers are those of stop_advance.
Progress arrive_advance(const StopContext& context, const State& start, const State& goal, const MotionLimits& limits,
                        int choice, GrowScratch& scratch, EndStop& stop, Work& work) noexcept;

/// Puts the start's stop before a plan and the goal's behind it; either may be empty. False, with nothing changed, if
/// there is no capacity for all segments or polyhedra.
bool add_stops(const EndStop& start, const EndStop& goal, Corridor& corridor, Trajectory& trajectory) noexcept;

}  // namespace tern

#endif
