// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What follows a stage. A plan goes straight through the stages; after a failure, the list of attempts in fail() says
// where it enters them again.
#include "planner/layout.hpp"
#include "planner/pipeline.hpp"
#include "world/closed.hpp"

namespace tern {
namespace {

/// A capacity or the request's budget ran out.
bool lacks_room(Status status) {
  const bool capacity = status >= Status::kNodesFull && status < Status::kInfeasible;
  return capacity || status >= Status::kBudgetSearch;
}

/// The via that the failed part of the way leads to, or the via that it begins at if that one cannot be left. kNoVia if
/// that end is the start or the goal.
std::int32_t via_at_fault(Stage stage, const Legs& legs, const Rooms& rooms) {
  const bool on_leg = stage == Stage::kSearch || stage == Stage::kShortcut;
  if (!on_leg) return stage == Stage::kCorridor ? rooms.via : kNoVia;
  return legs.via;
}

}  // namespace

/// Resets what belongs to one goal.
void Pipeline::begin_goal() noexcept {
  Layout& memory = *memory_;
  results_ = {};
  curves_.stop_and_go = false;
  failure_ = {Stage::kRequest, Status::kOk, kNoVia, {}};
  attempts_.current = Attempt::kDirect;
  attempts_.detour = {};
  attempts_.stop_first = {};
  attempts_.waiting = {};
  attempts_.around = {};
  conflict_ = {};
  goal_free_ = GoalFree{};
  attempts_.follow.is_trial = attempts_.follow.leads_plan = false;
  take_ends(problem_, memory.ends);
  for (EndStop& stop : memory.stops) reset(stop);
  begin_trajectory(problem_, memory.trajectory);
  take_rest(*problem_.grid, problem_.asked, memory.previous);
}

/// Enters the first stage for a goal: the trial of the remainder if it leads there, else the search.
void Pipeline::begin_attempts() noexcept {
  attempts_.follow.proven = false;
  attempts_.follow.is_trial = follow_trial_is_due(memory_->previous);
  attempts_.follow.is_trial ? enter(Stage::kPrevious) : begin_way();
}

/// Begins the search for the first leg.
void Pipeline::begin_way() noexcept {
  results_.path = false;
  legs_begin(problem_, legs_, memory_->path);
  enter(Stage::kSearch);
}

/// Enters what follows the current stage, which is done or has failed.
void Pipeline::go_on(bool done) noexcept {
  if (attempts_.around.is_active && stage_ != Stage::kCheck) return go_on_around(done);
  switch (stage_) {
    case Stage::kWorld:
      if (reopens_) return go_on_from_tracks(false);
      if (problem_.goal_fault == Status::kOk) return begin_attempts();
      // Only the nearest point that can be reached is left to look for.
      failure_.status = problem_.goal_fault;
      legs_.leg = problem_.via_count;
      return give_up();
    case Stage::kSearch:
      return go_on_from_search(done);
    case Stage::kShortcut:
      return go_on_from_shortcut(done);
    case Stage::kCorridor:
      return go_on_from_corridor(done);
    case Stage::kTimes:
      return enter(Stage::kTrajectory);
    case Stage::kTrajectory:
      return go_on_from_trajectory(done);
    case Stage::kCheck:
      return go_on_from_check(done);
    case Stage::kDetour:
      if (!done) return fail(Stage::kTrajectory, attempts_.detour.without);
      attempts_.current = Attempt::kDetour;
      results_.corridor = false;
      return enter(Stage::kCorridor);
    case Stage::kPrevious:
      return go_on_from_previous(done);
    case Stage::kStopFirst:
      return go_on_from_stop(done);
    case Stage::kReach:
      return go_on_from_nearest(done);
    case Stage::kTracks:
      return go_on_from_tracks(done);
    case Stage::kRequest:
      break;
  }
}

void Pipeline::go_on_from_search(bool done) noexcept {
  if (!done) return fail(Stage::kSearch, legs_.status);
  if (wanted_ != Asked::kWay) return enter(Stage::kShortcut);
  results_.path = true;
  memory_->path.count = 0;
  end(Stage::kSearch, Status::kOk);
}

void Pipeline::go_on_from_shortcut(bool done) noexcept {
  if (!done) return choose_again(legs_.status, legs_) ? begin_way() : fail(Stage::kShortcut, legs_.status);
  results_.path = is_last_leg(problem_, legs_);
  if (!results_.path) {
    ++legs_.leg;
    enter(Stage::kSearch);
  } else if (wanted_ == Asked::kRoute) {
    end(Stage::kShortcut, Status::kOk);
  } else {
    enter(Stage::kCorridor);
  }
}

void Pipeline::go_on_from_corridor(bool done) noexcept {
  results_.corridor = done;
  if (done) return enter(Stage::kTimes);
  // If the detour has no corridor, the plan still fails because the path's own corridor has no trajectory.
  if (attempts_.current == Attempt::kDetour) return fail(Stage::kTrajectory, attempts_.detour.without);
  const bool again = attempts_.current == Attempt::kDirect && choose_again(rooms_.status, legs_);
  again ? begin_way() : fail(Stage::kCorridor, rooms_.status);
}

/// A chain that has to pass a via in motion has no stop-and-go to fall back to.
void Pipeline::go_on_from_trajectory(bool done) noexcept {
  Layout& memory = *memory_;
  quality_ = curves_.quality;
  optimiser_ = curves_.optimiser;
  attempts_.waiting = {};
  attempts_.around = {};
  if (!done && has_rival(memory.stage.trajectory.stage)) {
    end(Stage::kTrajectory, curves_.status);
    return;
  }
  if (!done) return fail(Stage::kTrajectory, curves_.status);
  if (problem_.thing_count > 0) memory.around.alone.trajectory = memory.trajectory;
  if (complete_trajectory(problem_, memory.stops, curves_, memory.vias, memory.trajectory)) {
    enter(Stage::kCheck);
  } else if (curves_.stop_and_go || hurries(memory.stage.trajectory.stage.chain)) {
    fail(Stage::kTrajectory, Status::kSegmentsFull);
  } else {
    stop_at_waypoints(Status::kSegmentsFull);
  }
}

void Pipeline::go_on_from_check(bool done) noexcept {
  Layout& memory = *memory_;
  if (attempts_.follow.is_trial) return end_trial(done);
  if (attempts_.around.is_active) return judge_around(done);
  if (!done) {
    refused_ = memory.stage.check.found;
    left_ = memory.stage.check.proof.left();
    if (meets_in_time(problem_, refused_)) return meet_track();
    const bool falls_back = quality_ == Quality::kOptimised && attempts_.current < Attempt::kStopFirst;
    return falls_back ? stop_at_waypoints(memory.stage.check.status) : fail(Stage::kCheck, memory.stage.check.status);
  }
  take_plan();
}

/// The plan in memory is clear.
void Pipeline::take_plan() noexcept {
  note_rest();
  end_plan();
}

/// Notes what the check found of the plan's ends.
void Pipeline::note_rest() noexcept {
  const CheckStage& check = memory_->stage.check;
  left_ = check.proof.left();
  rest_until_ = rest_clear_until(check);
}

/// The plan in memory is the answer, if the remainder of the previous plan is not.
void Pipeline::end_plan() noexcept {
  if (follows() || !prefers_remainder(attempts_.follow, memory_->trajectory)) {
    end(Stage::kCheck, Status::kOk);
    return;
  }
  optimiser_ = Status::kOk;
  attempts_.around = {};
  enter(Stage::kPrevious);
}

/// The check has refused the plan because of a track or of a fence for a while: time may help.
void Pipeline::meet_track() noexcept {
  if (conflict_.status == Status::kOk) conflict_ = conflict_of(refused_, left_);
  if (attempts_.waiting.is_tried || follows()) return go_on_from_tracks(false);
  const bool leads = problem_.thing_count > 0 && may_lead_around(quality_, results_.corridor);
  leads ? begin_around() : enter(Stage::kTracks);
}

void Pipeline::go_on_from_tracks(bool done) noexcept {
  if (done) return enter(Stage::kCheck);
  reopens_ = open_world(memory_->world);
  if (reopens_) return enter(Stage::kWorld);
  const Status lacking = attempts_.around.lacking;
  fail(Stage::kTracks, lacking != Status::kOk ? lacking : conflict_.status);
}

/// A remainder that ends elsewhere than at the goal takes the place of the start's stop. If it has no room, the reason
/// for the plan's failure stays the same.
void Pipeline::go_on_from_previous(bool done) noexcept {
  if (!done) return attempts_.follow.is_trial ? end_trial(false) : fail(failure_.stage, failure_.status);
  if (!memory_->previous.meets_goal) return enter(Stage::kStopFirst);
  check_as_is(Quality::kPrevious, Attempt::kFollow);
}

/// Once each end in motion has a stop, the plan begins again between the places of rest.
void Pipeline::go_on_from_stop(bool done) noexcept {
  if (!done) return give_up();
  if (attempts_.stop_first.arrived) {
    optimiser_ = Status::kOk;  // the optimiser's status belongs to another corridor
    return check_as_is(Quality::kStopAndGo, Attempt::kStopFirst);
  }
  results_.corridor = false;
  attempts_.current = attempts_.follow.leads_plan ? Attempt::kFollow : Attempt::kStopFirst;
  begin_way();
}

void Pipeline::go_on_from_nearest(bool done) noexcept {
  const NearestPoint& nearest = attempts_.nearest;
  if (!done) {
    const bool lacks_more = problem_.asked.goal_mode == GoalMode::kNearest && nearest.status != Status::kStartOccupied;
    end(lacks_more ? Stage::kReach : failure_.stage, lacks_more ? nearest.status : failure_.status);
  } else if (leads_to_nearest(problem_, memory_->stage.reach, failure_.status)) {
    make_nearest_the_goal(failure_.status, attempts_.nearest, problem_);
    begin_goal();
    begin_attempts();
  } else {
    end(failure_.stage, failure_.status);
  }
}

/// Ends the trial of the remainder. The plan begins as if nothing had been tried.
void Pipeline::end_trial(bool proven) noexcept {
  follow_note_trial(proven, problem_, memory_->previous, attempts_.follow);
  begin_goal();
  begin_way();
}

/// Passes the trajectory in memory to the check. It has neither path nor corridor.
void Pipeline::check_as_is(Quality quality, Attempt attempt) noexcept {
  quality_ = quality;
  attempts_.current = attempt;
  attempts_.waiting = {};
  attempts_.around = {};
  results_ = {};
  enter(Stage::kCheck);
}

/// Replaces the optimiser's plan by stop-and-go along the same corridor.
void Pipeline::stop_at_waypoints(Status why) noexcept {
  refuse_optimised(why, curves_);
  enter(Stage::kTimes);
}

/// The list of attempts: enters the first one that may help after a failure.
///
/// The plan's status is that of the first failure, which describes the request as it was given. But if a later attempt
/// lacked only capacity or budget, that is the status: with more of it there may be a plan.
void Pipeline::fail(Stage stage, Status status) noexcept {
  segments_full_ = segments_full_ || status == Status::kSegmentsFull;
  const bool is_first = attempts_.stop_first.tries == 0 && !memory_->previous.tried;
  const bool has_none = failure_.status == Status::kOk;  // so that no failure ends as a success
  if (is_first || has_none || lacks_room(status))
    failure_ = {stage, status, via_at_fault(stage, legs_, rooms_), legs_.fault};
  const bool is_direct = attempts_.current == Attempt::kDirect;
  if (is_direct && stage == Stage::kTrajectory && detour_may_help(problem_, attempts_.detour)) {
    enter(Stage::kDetour);
  } else if (follow_may_help(problem_, memory_->previous, status)) {
    enter(Stage::kPrevious);
  } else if (stop_first_may_help(problem_, attempts_.stop_first, stage, status)) {
    enter(Stage::kStopFirst);
  } else {
    give_up();
  }
}

/// Nothing else is left to try for the goal.
void Pipeline::give_up() noexcept {
  if (nearest_point_may_help(attempts_.nearest, failure_.status)) return enter(Stage::kReach);
  end(failure_.stage, failure_.status);
}

}  // namespace tern
