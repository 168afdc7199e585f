// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a plan goes through besides where an end moves and the corridor has no room for its motion: a detour along the
// path, then an escape to rest. And how often, which bounds the work.
#include "base/math.hpp"
#include "base/progress.hpp"
#include "base/work.hpp"
#include "curve/rest.hpp"
#include "grid/distance.hpp"
#include "planner/detour.hpp"
#include "planner/escape.hpp"
#include "planner/layout.hpp"
#include "planner/plan.hpp"
#include "planner/validate.hpp"

namespace tern {
namespace {

/// Stops that a plan goes on from at most: from the first few there may be no path.
constexpr std::uint32_t kEscapeTries = 3;

/// Half-spaces that all choices of a plan make at most: the ways to rest of both ends, and the arrivals.
constexpr std::uint32_t kEscapeBound = (2u * kStoppingChoices + kArrivals) * kEscapePlanes;

/// A capacity or the request's budget ran out.
bool lacks_room(Status status) {
  const bool capacity = status >= Status::kNodesFull && status < Status::kInfeasible;
  return capacity || status >= Status::kBudgetSearch;
}

}  // namespace

bool Plan::rests() const noexcept {
  return at_rest(asked_.start) && at_rest(asked_.goal);
}

/// To the goal, and to the reachable point instead.
std::uint32_t Plan::attempts() const noexcept {
  return asked_.goal_mode == GoalMode::kNearest ? 2 : 1;
}

std::uint32_t Plan::searches() const noexcept {
  return attempts() * (given_at_rest_ ? 1 : 1 + kEscapeTries);
}

std::uint32_t Plan::corridors() const noexcept {
  return attempts() * (given_at_rest_ ? 1 : 2 + kEscapeTries);
}

/// Each corridor's plan may be checked, the optimiser's first, then the fallback's; and the previous plan's rest.
std::uint32_t Plan::checks() const noexcept {
  return corridors() + attempts() * (asked_.previous != nullptr ? 1 + kPreviousTries : 1);
}

/// The start (0) or the goal (1) as it was asked for, relative to the plan's origin.
State Plan::asked_end(int end) const noexcept {
  State state = end == 0 ? asked_.start : asked_.goal;
  state.position = end == 0 ? kZero : asked_.goal.position - asked_.start.position;
  return state;
}

/// One unit: both ends' detours. Corridor and trajectory begin again with what is left of their budgets.
Progress Plan::run_detour(Work& work) noexcept {
  if (!work.take()) return Progress::kMore;
  std::uint32_t lines = 0;
  const bool found = sight_lines_left() >= kDetourLines &&
                     take_detour(world(), fences(), to_local(*grid_, asked_), limits_, memory_->path, lines);
  count(Stage::kDetour, lines, asked_.budget.sight_lines, attempts() * kDetourLines);
  if (!found) {
    fail(Stage::kTrajectory, Status::kNoTrajectory);
    return Progress::kFailed;
  }
  report_.detours = kDetoured;
  has_corridor_ = false;
  enter(Stage::kCorridor);
  return Progress::kDone;
}

/// Where coming to rest first may help: an end moves, and what failed depends on its motion or on where the path
/// begins.
bool Plan::escape_may_help(Status status) const noexcept {
  if (rests() || escapes_ == kEscapeTries) return false;
  const FlightEnds& ends = memory_->ends;
  const double radius = world().spec().radius;
  switch (status) {
    case Status::kNoTrajectory:
    case Status::kCorridorBlocked:
      return true;
    case Status::kStartOccupied:
      return !at_rest(asked_.start) && point_clear(world(), ends.start_in_grid, radius);
    case Status::kGoalOccupied:
      return !at_rest(asked_.goal) && point_clear(world(), ends.goal_in_grid, radius);
    case Status::kNoPath:
    case Status::kSegmentsFull:
    case Status::kCheckFailed:
      return escapes_ > 0;  // from another stop there may be a path, or a shorter one
    default:
      return false;
  }
}

/// Ends the plan, or tries the previous plan's rest, then the next escape. What ends it is what failed first: that is
/// about the request as it was. But where a way on lacked only room or budget, that is the reason: with more there may
/// be a plan.
void Plan::fail(Stage stage, Status status) noexcept {
  if (lacks_room(status) || (escapes_ == 0 && memory_->previous.tries == 0)) {
    failed_stage_ = stage;
    failed_status_ = status;
  }
  if (previous_may_help(status)) {
    enter(Stage::kPrevious);
  } else if (escape_may_help(status)) {
    enter(Stage::kEscape);
  } else {
    give_up();
  }
}

/// The corridor and the trajectory at hand go to the check as they are.
void Plan::fly(Quality quality, std::int32_t detours) noexcept {
  report_.quality = quality;
  report_.detours = detours;
  has_corridor_ = true;
  enter(Stage::kCheck);
}

/// The half-spaces that the escape at hand has made.
void Plan::count_escape() noexcept {
  count(Stage::kEscape, memory_->stage.corridor.grow.planes, asked_.budget.planes, attempts() * kEscapeBound);
}

void Plan::begin_escape() noexcept {
  Layout& memory = *memory_;
  begin_hulls();
  // Another try drops one end's way: the start's, where that moves.
  if (escapes_ > 0) {
    memory.escapes[at_rest(asked_.start) ? 1 : 0].count = 0;
    memory.previous.flown = false;
  }
  ++escapes_;
}

/// One unit is one duration. True where the goal's motion is met: the plan is whole.
bool Plan::arrives(Work& work) noexcept {
  Layout& memory = *memory_;
  const EscapeRoom room{world(), memory.ends.origin_in_grid, false};
  if (at_rest(asked_.goal) || escapes_ > 1 || memory.escapes[0].count > 0) return false;
  while (arrivals_ < kArrivals && work.take()) {
    const bool arrived = arrive_try(room, asked_end(0), asked_end(1), limits_, arrivals_++, memory.stage.corridor.grow,
                                    memory.escapes[0]);
    count_escape();
    if (!arrived) continue;
    memory.corridor.count = memory.trajectory.count = 0;
    memory.trajectory.origin = asked_.start.position;
    add_escapes(memory.escapes[0], memory.escapes[1], memory.corridor, memory.trajectory);
    memory.escapes[0].count = 0;
    return true;
  }
  return false;
}

/// One unit is one choice of one end. With a way to rest for each end that moves the plan begins again between them.
Progress Plan::run_escape(Work& work) noexcept {
  Layout& memory = *memory_;
  if (arrives(work)) {
    fly(Quality::kStopAndGo, kEscaped);
    return Progress::kDone;
  }
  for (int e = 0; e < 2; ++e) {
    const State state = asked_end(e);
    Escape& escape = memory.escapes[e];
    const EscapeRoom room{world(), memory.ends.origin_in_grid, e == 1};
    while (!at_rest(state) && escape.count == 0) {
      if (escape.next == kStoppingChoices) {
        give_up();
        return Progress::kFailed;
      }
      if (!work.take()) return Progress::kMore;
      escape_try(room, state, limits_, memory.stage.corridor.grow, escape);
      count_escape();
    }
  }
  rest_at_escapes();
  has_path_ = false;
  has_corridor_ = false;
  report_.detours = memory.previous.flown ? kFollowed : kEscaped;
  enter(Stage::kSearch);
  return Progress::kDone;
}

/// The plan's ends become the stops.
void Plan::rest_at_escapes() noexcept {
  Layout& memory = *memory_;
  FlightEnds& ends = memory.ends;
  const Box boundary = world().local_boundary();
  if (memory.escapes[0].count > 0) {
    ends.start = {memory.escapes[0].rest, kZero, kZero};
    ends.start_in_grid = nearest_in_box(ends.origin_in_grid + ends.start.position, boundary);
  }
  if (memory.escapes[1].count > 0) {
    ends.goal = {memory.escapes[1].rest, kZero, kZero};
    ends.goal_in_grid = nearest_in_box(ends.origin_in_grid + ends.goal.position, boundary);
  }
}

}  // namespace tern
