// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Further attempts for an end in motion, if the corridor has no room for the motion: a detour along the path, then an
// escape to rest. Also how often each is tried, which bounds the work.
#include "base/math.hpp"
#include "base/progress.hpp"
#include "base/work.hpp"
#include "curve/rest.hpp"
#include "planner/detour.hpp"
#include "planner/escape.hpp"
#include "planner/layout.hpp"
#include "planner/plan.hpp"
#include "planner/validate.hpp"

namespace tern {
namespace {

/// The most stops from which a plan tries to go on. From the first ones there may be no path.
constexpr std::uint32_t kEscapeTries = 3;

/// The most half-spaces that a plan makes for the stops of both ends and the arrivals together.
constexpr std::uint32_t kEscapeBound = (2u * kStoppingChoices + kArrivals) * kEscapePlanes;

/// Instructions of a detour, and of each line that it looks along.
constexpr std::uint32_t kDetourEffort = 20000;
constexpr std::uint32_t kDetourLineEffort = 15000;

/// A capacity or the request's budget ran out.
bool lacks_room(Status status) {
  const bool capacity = status >= Status::kNodesFull && status < Status::kInfeasible;
  return capacity || status >= Status::kBudgetSearch;
}

}  // namespace

bool Plan::rests() const noexcept {
  return at_rest(asked_.start) && at_rest(asked_.goal);
}

/// Goals that the plan may try: the requested one and, with GoalMode::kNearest, the reachable point instead.
std::uint32_t Plan::attempts() const noexcept {
  return asked_.goal_mode == GoalMode::kNearest ? 2 : 1;
}

std::uint32_t Plan::searches() const noexcept {
  return attempts() * (given_at_rest_ ? 1 : 1 + kEscapeTries);
}

/// The most units of all searches together, if one search takes at most `bound` units a leg.
std::uint32_t Plan::legs_searched(std::uint32_t bound) const noexcept {
  const std::uint64_t legs =
      static_cast<std::uint64_t>(searches() + searched_again_) * static_cast<std::uint64_t>(via_count() + 1);
  const std::uint64_t all = legs * bound;
  return all < 0xFFFFFFFFu ? static_cast<std::uint32_t>(all) : 0xFFFFFFFFu;
}

std::uint32_t Plan::corridors() const noexcept {
  return attempts() * (given_at_rest_ ? 1 : 2 + kEscapeTries);
}

/// The most checks of a plan: for each corridor the optimiser's plan, then the fallback; and the rest of the previous
/// plan.
std::uint32_t Plan::checks() const noexcept {
  return corridors() + attempts() * (asked_.previous != nullptr ? 1 + 2 * kPreviousTries : 1);
}

/// The requested start (0) or goal (1), relative to the plan's origin.
State Plan::asked_end(int end) const noexcept {
  State state = end == 0 ? asked_.start : asked_.goal;
  state.position = end == 0 ? kZero : asked_.goal.position - asked_.start.position;
  return state;
}

/// One unit makes the detours of both ends. Corridor and trajectory then begin again with what is left of their
/// budgets.
Progress Plan::run_detour(Work& work) noexcept {
  if (!work.take()) return Progress::kMore;
  std::uint32_t lines = 0;
  const bool found = sight_lines_left() >= kDetourLines &&
                     take_detour(world(), to_local(voxels(), asked_), limits_, memory_->path, lines);
  work.effort += kDetourEffort + lines * kDetourLineEffort;
  count(Stage::kDetour, lines, asked_.budget.sight_lines, attempts() * kDetourLines);
  if (!found) {
    fail(Stage::kTrajectory, undetoured_);
    return Progress::kFailed;
  }
  report_.diagnostics.detours = kDetoured;
  has_corridor_ = false;
  enter(Stage::kCorridor);
  return Progress::kDone;
}

/// True if coming to rest first may help: an end is in motion, and the failure depends on that motion or on the place
/// where the path begins.
bool Plan::escape_may_help(Stage stage, Status status) const noexcept {
  if (rests() || escapes_ == kEscapeTries) return false;
  switch (status) {
    case Status::kNoTrajectory:
    case Status::kCorridorBlocked:
      return true;
    case Status::kStartTooNarrow:
      return !at_rest(asked_.start);
    case Status::kGoalTooNarrow:
      return !at_rest(asked_.goal);
    case Status::kSegmentsFull:
      return escapes_ > 0 || stage == Stage::kTrajectory;  // from rest to rest, stop-and-go takes fewer segments
    case Status::kNoPath:
    case Status::kCheckFailed:
      return escapes_ > 0;  // from another stop there may be a path, or a shorter one
    default:
      return false;
  }
}

/// After a failure: tries the rest of the previous plan, then the next escape, then ends the plan. The plan's status is
/// that of the first failure, which describes the request as it was given. But if a later attempt lacked only capacity
/// or budget, that is the status: with more of it there may be a plan.
void Plan::fail(Stage stage, Status status) noexcept {
  if (status == Status::kSegmentsFull) raise(report_.diagnostics.high_water.segments, kMaxSegments);
  if (lacks_room(status) || (escapes_ == 0 && memory_->previous.tries == 0)) {
    failed_stage_ = stage;
    failed_status_ = status;
    report_.via = via_at_fault(stage);
  }
  if (previous_may_help(status)) {
    enter(Stage::kPrevious);
  } else if (escape_may_help(stage, status)) {
    enter(Stage::kEscape);
  } else {
    give_up();
  }
}

/// Passes the current corridor and trajectory to the check as they are.
void Plan::fly(Quality quality, std::int32_t detours) noexcept {
  report_.quality = quality;
  report_.diagnostics.detours = detours;
  has_corridor_ = true;
  enter(Stage::kCheck);
}

/// Counts the half-spaces that the current escape has made.
void Plan::count_escape() noexcept {
  count(Stage::kEscape, memory_->stage.corridor.grow.planes, asked_.budget.planes, attempts() * kEscapeBound);
}

void Plan::begin_escape() noexcept {
  Layout& memory = *memory_;
  begin_hulls();
  // A second attempt discards the escape of one end: the start's, if the start is in motion.
  if (escapes_ > 0) {
    memory.escapes[at_rest(asked_.start) ? 1 : 0].count = 0;
    memory.previous.flown = false;
  }
  ++escapes_;
}

/// Tries durations of an arrival. kDone: the curve has room; it is then the whole plan. It passes no vias. kFailed: no
/// duration is left.
Progress Plan::run_arrivals(Work& work) noexcept {
  Layout& memory = *memory_;
  Escape& escape = memory.escapes[0];
  const EscapeRoom room{world(), memory.ends.origin_in_grid, false};
  if (via_count() > 0 || at_rest(asked_.goal) || escapes_ > 1 || escape.count > 0) return Progress::kFailed;
  for (; arrivals_ < kArrivals; ++arrivals_) {
    const Progress arrived =
        arrive_advance(room, asked_end(0), asked_end(1), limits_, arrivals_, memory.stage.corridor.grow, escape, work);
    count_escape();
    if (arrived == Progress::kMore) return arrived;
    if (arrived == Progress::kFailed) continue;
    memory.corridor.count = memory.trajectory.count = 0;
    memory.trajectory.origin = asked_.start.position;
    add_escapes(escape, memory.escapes[1], memory.corridor, memory.trajectory);
    escape.count = 0;
    ++arrivals_;
    return Progress::kDone;
  }
  return Progress::kFailed;
}

/// Tries stops for the end. kDone: one has room, or the end is at rest. kFailed: no stop is left to try.
Progress Plan::run_choices(int end, Work& work) noexcept {
  Layout& memory = *memory_;
  const State state = asked_end(end);
  Escape& escape = memory.escapes[end];
  const EscapeRoom room{world(), memory.ends.origin_in_grid, end == 1};
  while (!at_rest(state) && escape.count == 0) {
    if (!escape.trying && escape.next == kStoppingChoices) return Progress::kFailed;
    const Progress tried = escape_advance(room, state, limits_, memory.stage.corridor.grow, escape, work);
    count_escape();
    if (tried == Progress::kMore) return tried;
  }
  return Progress::kDone;
}

/// Once each end in motion has an escape, the plan begins again between their places of rest.
Progress Plan::run_escape(Work& work) noexcept {
  Layout& memory = *memory_;
  const Progress arrived = run_arrivals(work);
  if (arrived == Progress::kMore) return arrived;
  if (arrived == Progress::kDone) {
    report_.optimiser = Status::kOk;  // the optimiser's status belongs to another corridor
    fly(Quality::kStopAndGo, kEscaped);
    return Progress::kDone;
  }
  for (int end = 0; end < 2; ++end) {
    const Progress progress = run_choices(end, work);
    if (progress == Progress::kMore) return progress;
    if (progress == Progress::kDone) continue;
    give_up();
    return progress;
  }
  rest_at_escapes();
  has_corridor_ = false;
  report_.diagnostics.detours = memory.previous.flown ? kFollowed : kEscaped;
  begin_way();
  return Progress::kDone;
}

/// Makes the places of rest the ends of the plan.
void Plan::rest_at_escapes() noexcept {
  Layout& memory = *memory_;
  FlightEnds& ends = memory.ends;
  const Box boundary = voxels().local_boundary();
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
