// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/stop_first.hpp"

#include "base/math.hpp"
#include "curve/rest.hpp"
#include "grid/distance.hpp"

namespace tern {
namespace {

/// Tries durations of an arrival. kDone: the curve has room. It passes no vias. kFailed: no duration is left.
Progress advance_arrivals(const Problem& problem, const RoomProof& room, StopFirst& stop_first, EndStop& stop,
                          Work& work) {
  if (problem.via_count > 0 || at_rest(problem.asked.goal) || stop_first.tries > 1 || stop.count > 0) {
    return Progress::kFailed;
  }
  for (; stop_first.arrivals < kArrivals; ++stop_first.arrivals) {
    const Progress arrived = arrive_advance(room, asked_end(problem, 0), asked_end(problem, 1), problem.limits,
                                            stop_first.arrivals, stop, work);
    if (arrived == Progress::kMore) return arrived;
    if (arrived == Progress::kFailed) continue;
    ++stop_first.arrivals;
    return Progress::kDone;
  }
  return Progress::kFailed;
}

/// Tries stops for the end. kDone: one has room, or the end is at rest. kFailed: no stop is left to try.
Progress advance_stops(const Problem& problem, const RoomProof& room, int end, EndStop& stop, Work& work) {
  const State state = asked_end(problem, end);
  while (!at_rest(state) && stop.count == 0) {
    if (!stop.is_tried && stop.next_choice == kStoppingChoices) return Progress::kFailed;
    if (stop_advance(room, state, end == 1, problem.limits, stop, work) == Progress::kMore) return Progress::kMore;
  }
  return Progress::kDone;
}

/// Makes the places of rest the ends of the plan.
void end_at_stops(const Problem& problem, const EndStop* stops, Ends& ends) {
  const Box boundary = voxels_of(problem).local_boundary();
  if (stops[0].count > 0) {
    ends.start = {stops[0].place, kZero, kZero};
    ends.start_in_grid = nearest_in_box(ends.origin_in_grid + ends.start.position, boundary);
  }
  if (stops[1].count > 0) {
    ends.goal = {stops[1].place, kZero, kZero};
    ends.goal_in_grid = nearest_in_box(ends.origin_in_grid + ends.goal.position, boundary);
  }
}

}  // namespace

bool stop_first_may_help(const Problem& problem, const StopFirst& stop_first, Stage stage, Status status) noexcept {
  if (rests(problem) || stop_first.tries == kStopFirstTries) return false;
  switch (status) {
    case Status::kNoTrajectory:
    case Status::kCorridorBlocked:
      return true;
    case Status::kNoClearTime:
    case Status::kGoalCovered:
    case Status::kStartInContact:
    case Status::kStartTooNarrow:
      return !at_rest(problem.asked.start);
    case Status::kGoalTooNarrow:
      return !at_rest(problem.asked.goal);
    case Status::kSegmentsFull:
      // From rest to rest, stop-and-go takes fewer segments.
      return stop_first.tries > 0 || stage == Stage::kTrajectory;
    case Status::kNoPath:
    case Status::kCheckFailed:
      return stop_first.tries > 0;  // from another stop there may be a path, or a shorter one
    default:
      return false;
  }
}

void stop_first_begin(const Problem& problem, StopFirst& stop_first, EndStop* stops) noexcept {
  if (stop_first.tries > 0) stops[at_rest(problem.asked.start) ? 1 : 0].count = 0;
  ++stop_first.tries;
  stop_first.arrived = false;
}

Progress stop_first_advance(const Problem& problem, const RoomProof& room, StopFirst& stop_first, EndStop* stops,
                            Ends& ends, Work& work) noexcept {
  const Progress arrived = advance_arrivals(problem, room, stop_first, stops[0], work);
  if (arrived == Progress::kMore) return arrived;
  stop_first.arrived = arrived == Progress::kDone;
  if (stop_first.arrived) {
    stops[0].count = 0;  // it is the whole plan
    return Progress::kDone;
  }
  for (int end = 0; end < 2; ++end) {
    const Progress stopped = advance_stops(problem, room, end, stops[end], work);
    if (stopped != Progress::kDone) return stopped;
  }
  end_at_stops(problem, stops, ends);
  return Progress::kDone;
}

}  // namespace tern
