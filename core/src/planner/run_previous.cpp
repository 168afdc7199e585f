// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The rest of the previous plan, which is flown if no new plan is found that arrives earlier. It is proven on the
// current map before the search for a new plan, so that a rest that does not hold costs little. If it is to be flown,
// it is proven once more, because the new plan took its memory.
#include "base/progress.hpp"
#include "base/too_narrow.hpp"
#include "base/work.hpp"
#include "curve/rest.hpp"
#include "planner/layout.hpp"
#include "planner/plan.hpp"
#include "planner/validate.hpp"
#include "prove/grants.hpp"

namespace tern {
namespace {

/// The part of check_distance by which hulls of the rest may come closer to obstacles than touching allows. A checked
/// plan may violate a half-space by the check's tolerance, and the half-space itself may be too near to an obstacle. So
/// the plan's hulls may be too near by both. A factor below 1 leaves room for rounding.
constexpr double kPreviousSlack = 0.9;
/// A new plan replaces the rest if it arrives earlier by more than this, seconds.
constexpr double kEarlierBy = 1e-6;

}  // namespace

/// Enters the first stage of an attempt: the trial of the rest if it ends at the goal, else the search.
void Plan::begin_with_rest() noexcept {
  const Previous& rest = memory_->previous;
  rest_try_ = 0;
  tries_rest_ = rest.count > 0 && rest.meets_goal;
  tries_rest_ ? enter(Stage::kPrevious) : begin_way();
}

/// Ends a trial of the rest. If it does not hold, the next way is tried. After the last, or if it holds, the attempt
/// begins anew as if nothing had been tried.
Progress Plan::end_trial(bool holds) noexcept {
  const Previous& rest = memory_->previous;
  if (!holds && rest.tries < rest.last_try) {
    enter(Stage::kPrevious);
    return Progress::kFailed;
  }
  rest_try_ = holds ? rest.tries : 0;
  rest_time_ = duration(memory_->trajectory);
  rest_planes_ = report_.diagnostics.stages[static_cast<int>(Stage::kPrevious)].work;
  asked_.previous = &memory_->previous.plan;
  report_.quality = Quality::kNone;
  begin_attempt();
  begin_way();
  return Progress::kDone;
}

bool Plan::prefers_rest() const noexcept {
  const Previous& rest = memory_->previous;
  if (rest_try_ == 0 || (rest.flown && rest.meets_goal) || planes_left() < rest_planes_) return false;
  return !(duration(memory_->trajectory) < rest_time_ - kEarlierBy);
}

void Plan::return_to_rest() noexcept {
  cut_previous(*grid_, asked_, memory_->previous);
  memory_->previous.tries = rest_try_ - 1;
  report_.optimiser = Status::kOk;
  enter(Stage::kPrevious);
}

/// Prepares the memory for polyhedra around hulls.
void Plan::begin_hulls() noexcept {
  Layout& memory = *memory_;
  GrowScratch& scratch = memory.stage.corridor.grow;
  reset_counters(scratch);
  scratch.planes_allowed = planes_left();
}

/// True if the rest of the previous plan may help after this failure. A rest that ends elsewhere than at the goal
/// cannot help if no voxel near the goal is free.
bool Plan::previous_may_help(Status status) const noexcept {
  const Previous& rest = memory_->previous;
  if (rest.tries == rest.last_try || rest.count == 0) return false;
  if (rest.meets_goal) return true;
  return rest.tries == 0 && !lacks_goal_voxel(status) && !at_rest(asked_.start);
}

void Plan::begin_previous() noexcept {
  Previous& rest = memory_->previous;
  if (++rest.tries > 1) cut_again(asked_, rest);
  rest.flown = false;
  rest.appends = false;
  begin_hulls();
}

/// The units are those of append_advance. If the rest meets the goal, it is the whole plan. Otherwise it takes the
/// place of the start's escape.
Progress Plan::run_previous(Work& work) noexcept {
  Layout& memory = *memory_;
  Previous& rest = memory.previous;
  GrowScratch& scratch = memory.stage.corridor.grow;
  Escape& escape = memory.escapes[0];
  Tube tube = tube_of(escape, kMaxSegments);
  if (rest.meets_goal) tube = {memory.trajectory.segments, memory.corridor.polyhedra, kMaxSegments, 0, 0.0};
  tube.count = rest.enclosed;
  tube.slack = kPreviousSlack * check_distance(*grid_);
  const Vec3 origin = rest.in_place ? grid_->to_local(rest.origin) : memory.ends.origin_in_grid;
  for (; rest.next < rest.count; ++rest.next) {
    if (!rest.appends) append_begin(rest.appending, rest.segments[rest.next]);
    const Progress progress = append_advance(rest.appending, world(), origin, scratch, tube, work);
    rest.appends = progress == Progress::kMore;
    rest.enclosed = tube.count;
    count(Stage::kPrevious, scratch.planes, asked_.budget.planes, attempts() * kPreviousPlanes);
    if (progress == Progress::kMore) return progress;
    if (progress == Progress::kFailed) return drop_previous(rest.appending.status);
  }
  rest.flown = true;
  if (rest.meets_goal) {
    follow_previous();
  } else {
    escape.count = rest.enclosed;
    escape.rest = end_of(rest);
    enter(Stage::kEscape);
  }
  return Progress::kDone;
}

/// Gives the rest up. The reason for the plan's failure stays the same, unless the rest lacked only segments.
Progress Plan::drop_previous(Status why) noexcept {
  if (tries_rest_) return end_trial(false);
  const Stage stage = failed_stage_;
  const Status first = failed_status_;
  if (why == Status::kSegmentsFull) {
    failed_stage_ = Stage::kPrevious;
    failed_status_ = why;
  }
  fail(stage, first);
  return Progress::kFailed;
}

/// Makes the rest the whole plan.
void Plan::follow_previous() noexcept {
  Layout& memory = *memory_;
  memory.corridor.count = memory.trajectory.count = memory.previous.enclosed;
  memory.trajectory.origin = memory.previous.origin;
  has_path_ = false;
  fly(Quality::kPrevious, kFollowed);
}

Vec3 Plan::start_jerk() const noexcept {
  const Previous& rest = memory_->previous;
  return rest.flown ? rest.jerk : asked_.start.jerk;
}

}  // namespace tern
