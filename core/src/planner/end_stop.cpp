// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/end_stop.hpp"

#include "base/bounds.hpp"
#include "base/capacity.hpp"
#include "curve/motion_limits.hpp"
#include "curve/rest.hpp"
#include "planner/tube.hpp"

namespace tern {
namespace {

void shift(int by, Corridor& corridor, Trajectory& trajectory) {
  for (int i = corridor.count - 1; i >= 0; --i) corridor.polyhedra[i + by] = corridor.polyhedra[i];
  for (int i = trajectory.count - 1; i >= 0; --i) {
    trajectory.segments[i + by] = trajectory.segments[i];
    trajectory.segments[i + by].polyhedron += by;
  }
  corridor.count += by;
  trajectory.count += by;
}

/// Puts the stop's segments at index `segment_at` and its polyhedra at index `polyhedron_at`.
void put(const EndStop& stop, int segment_at, int polyhedron_at, Corridor& corridor, Trajectory& trajectory) {
  for (int i = 0; i < stop.count; ++i) {
    corridor.polyhedra[polyhedron_at + i] = stop.polyhedra[i];
    trajectory.segments[segment_at + i] = stop.segments[i];
    trajectory.segments[segment_at + i].polyhedron += polyhedron_at;
  }
}

/// Makes the stop of the next_choice choice. False if it breaks the limits.
bool make_stop(const StopContext& context, const State& state, const MotionLimits& limits, EndStop& stop) {
  const int choice = stop.next_choice++;
  Stopping& stopping = stop.stopping;
  const bool kept = context.to_goal ? make_stopping(backwards(state), backwards(limits), choice, stopping)
                                    : make_stopping(state, limits, choice, stopping);
  if (!kept) return false;
  stop.place = rest_of(stopping);
  if (context.to_goal) reverse(stopping);
  return true;
}

/// Makes one curve from state to state. False if it breaks the limits.
bool make_arrival(const State& start, const State& goal, const MotionLimits& limits, int choice, Stopping& out) {
  // Durations to try, in parts of what the way takes at the mean of both velocities.
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

void begin_trial(EndStop& stop) {
  stop.is_tried = true;
  stop.enclosed = stop.appended = 0;
  append_begin(stop.enclosure, stop.stopping.segments[0]);
}

/// Appends the segments of the current stop or arrival to the tube.
Progress advance_trial(const StopContext& context, GrowScratch& scratch, EndStop& stop, Work& work) {
  Tube tube = tube_of(stop, kStopSegments);
  tube.count = stop.enclosed;
  Progress progress = Progress::kDone;
  while (progress == Progress::kDone && stop.appended < stop.stopping.count) {
    progress = append_advance(stop.enclosure, context.world, context.origin, scratch, tube, work);
    stop.enclosed = tube.count;
    if (progress == Progress::kMore) return progress;
    if (++stop.appended < stop.stopping.count) {
      append_begin(stop.enclosure, stop.stopping.segments[stop.appended]);
    }
  }
  stop.is_tried = false;
  stop.count = progress == Progress::kDone ? stop.enclosed : 0;
  return progress;
}

}  // namespace

Progress stop_advance(const StopContext& context, const State& state, const MotionLimits& limits, GrowScratch& scratch,
                      EndStop& stop, Work& work) noexcept {
  if (!stop.is_tried) {
    if (!work.left()) return Progress::kMore;
    work.spend(kStopOperations);
    if (!make_stop(context, state, limits, stop)) return Progress::kFailed;
    begin_trial(stop);
  }
  return advance_trial(context, scratch, stop, work);
}

Progress arrive_advance(const StopContext& context, const State& start, const State& goal, const MotionLimits& limits,
                        int choice, GrowScratch& scratch, EndStop& stop, Work& work) noexcept {
  if (!stop.is_tried) {
    if (!work.left()) return Progress::kMore;
    work.spend(14 * ops::kCurve);
    stop.count = 0;
    if (!make_arrival(start, goal, limits, choice, stop.stopping)) return Progress::kFailed;
    begin_trial(stop);
  }
  return advance_trial(context, scratch, stop, work);
}

bool add_stops(const EndStop& start, const EndStop& goal, Corridor& corridor, Trajectory& trajectory) noexcept {
  const int more = start.count + goal.count;
  if (is_full(corridor.count + more > kMaxSegments || trajectory.count + more > kMaxSegments)) return false;
  shift(start.count, corridor, trajectory);
  put(start, 0, 0, corridor, trajectory);
  put(goal, trajectory.count, corridor.count, corridor, trajectory);
  corridor.count += goal.count;
  trajectory.count += goal.count;
  return true;
}

}  // namespace tern
