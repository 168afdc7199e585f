// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/end_stop.hpp"

#include "base/bounds.hpp"
#include "base/capacity.hpp"
#include "curve/motion_limits.hpp"
#include "curve/rest.hpp"
#include "planner/hints.hpp"
#include "prove/grants.hpp"

namespace tern {
namespace {

/// Makes the stop of the choice number `next_choice`. False if it breaks the limits.
bool make_stop(const State& state, bool to_goal, const MotionLimits& limits, EndStop& stop) {
  const int choice = stop.next_choice++;
  Stopping& stopping = stop.stopping;
  const bool kept = to_goal ? make_stopping(backwards(state), backwards(limits), choice, stopping)
                            : make_stopping(state, limits, choice, stopping);
  if (!kept) return false;
  stop.place = rest_of(stopping);
  if (to_goal) reverse(stopping);
  return true;
}

/// Makes one curve from state to state. False if it breaks the limits.
bool make_arrival(const State& start, const State& goal, const MotionLimits& limits, int choice, Stopping& out) {
  // Durations to try, in parts of the time that the way takes at the mean of both velocities.
  constexpr double kParts[kArrivals] = {1.0, 1.01, 0.99, 1.03, 0.97, 1.1, 0.9, 1.25, 0.8, 1.5, 2.0, 3.0};
  const double speed = 0.5 * length(start.velocity + goal.velocity);
  const double way = distance(start.position, goal.position);
  if (!(speed > 0.0) || !(way > 0.0)) return false;
  out.count = 1;
  Segment& segment = out.segments[0];
  segment = Segment{};
  segment.duration = kParts[choice] * (way / speed);
  control_points({{start.position, start.velocity, start.acceleration, start.jerk}},
                 {{goal.position, goal.velocity, goal.acceleration, goal.jerk}}, segment.duration, segment.points);
  return within_limits(segment, limits, kStopTolerance);
}

/// Begins the proof of the current stop or arrival. False if it has too many segments.
bool begin_trial(const RoomProof& room, EndStop& stop) {
  const Stopping& stopping = stop.stopping;
  if (is_full(stopping.count > kMaxSegments)) return false;
  stop.is_tried = true;
  for (int i = 0; i < stopping.count; ++i) {
    room.curve.segments[i] = stopping.segments[i];
    room.curve.segments[i].polyhedron = kNoPolyhedron;
  }
  room.curve.count = stopping.count;
  check_begin(room.stage);
  return true;
}

/// A stop may use half of what a plan is granted, as the stages may: the plan goes on from its end, and is granted more
/// only because a face of the boundary may have moved onto the lattice.
Progress advance_trial(const RoomProof& room, EndStop& stop, Work& work) {
  const double spare = larger(check_distance(room.grid), lattice_rounding(room.grid));
  const Progress progress = prove_room(room, spare, work);
  if (progress == Progress::kMore) return progress;
  stop.is_tried = false;
  stop.count = progress == Progress::kDone ? room.curve.count : 0;
  for (int i = 0; i < stop.count; ++i) stop.segments[i] = room.curve.segments[i];
  return progress;
}

}  // namespace

Progress prove_room(const RoomProof& room, double spare, Work& work) noexcept {
  const Progress hinted = hints_advance(room.around, nullptr, room.curve, room.stage.hints, work);
  if (hinted != Progress::kDone) return hinted;
  return room_advance(room.stage, room.grid, room.curve, room.world, spare, work);
}

Progress stop_advance(const RoomProof& room, const State& state, bool to_goal, const MotionLimits& limits,
                      EndStop& stop, Work& work) noexcept {
  if (!stop.is_tried) {
    if (!work.left()) return Progress::kMore;
    work.spend(kStopOperations);
    if (!make_stop(state, to_goal, limits, stop) || !begin_trial(room, stop)) return Progress::kFailed;
  }
  return advance_trial(room, stop, work);
}

Progress arrive_advance(const RoomProof& room, const State& start, const State& goal, const MotionLimits& limits,
                        int choice, EndStop& stop, Work& work) noexcept {
  if (!stop.is_tried) {
    if (!work.left()) return Progress::kMore;
    work.spend(14 * ops::kCurve);
    stop.count = 0;
    if (!make_arrival(start, goal, limits, choice, stop.stopping) || !begin_trial(room, stop)) return Progress::kFailed;
  }
  return advance_trial(room, stop, work);
}

bool add_stops(const EndStop& start, const EndStop& goal, Trajectory& trajectory) noexcept {
  const int way = trajectory.count;
  if (is_full(start.count + way + goal.count > kMaxSegments)) return false;
  for (int i = way - 1; i >= 0; --i) trajectory.segments[start.count + i] = trajectory.segments[i];
  for (int i = 0; i < start.count; ++i) trajectory.segments[i] = start.segments[i];
  for (int i = 0; i < goal.count; ++i) trajectory.segments[start.count + way + i] = goal.segments[i];
  trajectory.count += start.count + goal.count;
  return true;
}

}  // namespace tern
