// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A stop at an end of a plan that is in motion, by any manoeuvre that has room (curve/stopping.hpp). The stop of a goal
// is computed backwards in time, to a place where its motion can have begun. The certifier says what has room.
#ifndef TERN_PLANNER_END_STOP_HPP
#define TERN_PLANNER_END_STOP_HPP

#include "base/bounds.hpp"
#include "base/progress.hpp"
#include "base/work.hpp"
#include "curve/stopping.hpp"
#include "prove/check_stage.hpp"
#include "prove/fences.hpp"
#include "tern/grid.hpp"
#include "tern/request.hpp"
#include "tern/trajectory.hpp"
#include "world/world.hpp"

namespace tern {

/// The motion of one end to rest. It is one of the choices, or the remainder of the previous plan.
struct EndStop {
  int next_choice;    ///< to be tried next, 0 .. kStoppingChoices
  int count;          ///< segments; 0 if there is no motion yet
  bool is_tried;      ///< the choice before `next_choice` is being tried
  Stopping stopping;  ///< the current choice
  Vec3 place;         ///< the end of the motion (for a goal: its beginning), relative to the plan's origin
  Segment segments[kMaxSegments];
};

/// No choice is tried yet.
inline void reset(EndStop& stop) noexcept {
  stop.next_choice = stop.count = 0;
  stop.is_tried = false;
}

/// The inputs of a proof that a curve has room, and the memory for it.
struct RoomProof {
  const Grid& grid;
  const AskedWorld* world;  ///< the request's fences; null: none
  CheckStage& stage;
  Trajectory& curve;  ///< the curve that is proven; its origin is the plan's
  World around;       ///< the planner's view of the world, for hints
};

/// Proves that room.curve has room, as room_advance, with hints for it.
Progress prove_room(const RoomProof& room, double spare, Work& work) noexcept;

/// Tries the next choice for `state` (relative to the plan's origin), the goal's if `to_goal`. One piece of work makes
/// the stop; the others are those of prove_room. kDone: the stop has room and is filled in. kFailed: it has no room.
Progress stop_advance(const RoomProof& room, const State& state, bool to_goal, const MotionLimits& limits,
                      EndStop& stop, Work& work) noexcept;

/// Durations that an arrival tries.
constexpr int kArrivals = 12;

/// Tries an arrival: one curve from the start straight into the motion of the goal, with duration number `choice`, 0 ..
/// kArrivals - 1. This helps near the end of a flight, when there is no room left to stop before the goal. Its pieces
/// and answers are those of stop_advance.
Progress arrive_advance(const RoomProof& room, const State& start, const State& goal, const MotionLimits& limits,
                        int choice, EndStop& stop, Work& work) noexcept;

/// Puts the start's stop before a plan and the goal's behind it; either may be empty. False, with nothing changed, if
/// there is no capacity for all segments.
bool add_stops(const EndStop& start, const EndStop& goal, Trajectory& trajectory) noexcept;

}  // namespace tern

#endif
