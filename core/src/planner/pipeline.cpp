// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/pipeline.hpp"

#include <new>

#include "base/capacity.hpp"
#include "base/track_fault.hpp"
#include "planner/hints.hpp"
#include "planner/layout.hpp"
#include "planner/validate.hpp"

namespace tern {
namespace {

/// Of begin() and finish() together.
constexpr Operations kBeginOperations = 20 * ops::kCurve;

WayMemory way_of(Layout& memory) {
  return {memory.path, memory.vias.leg, memory.vias.marks};
}

bool pace_fits(const Request& request, const Trajectory& plan, double time) {
  return request.previous == nullptr && is_trajectory(plan) && finite(time) && time >= 0.0;
}

RoomProof room_of(const Problem& problem, Layout& memory) {
  return {*problem.grid, problem.asked_world, memory.stage.check, memory.trajectory, world_of(memory.world)};
}

/// The plan that sets the pace, if the chain begins on it. It is no rival of curves that lack their dwells.
Pace pace_of(const Problem& problem, const Curves& curves, const Layout& memory) {
  if (!problem.has_pace || curves.stop_and_go || memory.stops[0].count > 0) return {};
  const Trajectory& plan = memory.previous.plan;
  const bool is_rival = problem.must_beat_pace && !has_dwells(problem);
  return {&plan, problem.pace_from, plan.origin - problem.asked.start.position, is_rival};
}

/// `entered`: when the plan enters the trajectory. `goes_on`: it continues the previous plan, with the jerk of that
/// one.
CheckQuery check_query(const Problem& problem, const Layout& memory, double entered, bool goes_on) {
  const Request& asked = problem.asked;
  CheckQuery query{asked.start, asked.goal, asked.limits, entered, problem.asked_world};
  if (goes_on) query.start.jerk = memory.previous.jerk;
  query.vias = problem.vias;
  query.joints = memory.vias.joint;
  query.via_count = problem.via_count;
  query.tracks = problem.tracks;
  query.track_count = problem.track_count;
  query.rest = asked.rest_clear;
  return query;
}

/// What plans must be clear of.
TrackGrounds tracks_of(const Problem& problem) {
  TrackGrounds grounds{problem.tracks, problem.track_count, problem.grid->spec().clearance(), problem.asked.rest_clear,
                       true};
  if (!problem.has_windows) return grounds;
  grounds.fences = problem.asked_world->fence;
  grounds.fence_count = problem.asked_world->count;
  return grounds;
}

/// The check of the whole plan, with the hints of a corridor.
Progress prove_plan(const CheckQuery& query, const Corridor& corridor, const Grid& grid, Layout& memory, Work& work) {
  CheckStage& stage = memory.stage.check;
  const Progress hinted = hints_advance(world_of(memory.world), &corridor, memory.trajectory, stage.hints, work);
  if (hinted != Progress::kDone) return hinted;
  return check_advance(stage, grid, corridor, memory.trajectory, query, work);
}

}  // namespace

Status Pipeline::refuse(const RequestFault& fault) noexcept {
  fault_ = fault;
  failure_.via = fault.via;
  return end(Stage::kRequest, fault.status);
}

Status Pipeline::end(Stage stage, Status status) noexcept {
  ended_in_ = stage;
  status_ = status;
  return status;
}

Status Pipeline::begin(const Grid& grid, const Request& request, const PlanMode& mode, const Clock& clock) noexcept {
  Layout* const memory = memory_;
  new (this) Pipeline(*memory);  // in place: it is too large for the stack
  wanted_ = mode.wanted;
  ledger_.clear(clock);
  failure_.via = kNoVia;
  problem_.grid = &grid;
  problem_.version = grid.version();
  problem_.world = &memory->world;
  world_begin(memory->world, grid);
  begun_ = kBeginOperations;
  if (!grid.inflated()) return refuse({Status::kInvalidArgument, grid.bound() ? Field::kNotInflated : Field::kStorage});
  const Status status = read(request, mode);
  if (status != Status::kRunning) return status;
  status_ = Status::kRunning;
  memory->world.has_solids ? enter(Stage::kWorld) : begin_attempts();
  return status_;
}

/// Reads the request into the problem. kRunning, or why it is refused.
Status Pipeline::read(const Request& request, const PlanMode& mode) noexcept {
  Layout& memory = *memory_;
  const Verdict verdict = validate(*problem_.grid, request, problem_.limits);
  if (verdict.status != Status::kOk) return refuse({verdict.status, verdict.field});
  if (mode.pace != nullptr && !pace_fits(request, *mode.pace, mode.pace_time)) {
    return refuse({Status::kInvalidArgument, Field::kPrevious});
  }
  RequestFault fault{};
  const Verdict vias = validate_vias(*problem_.grid, request, problem_.limits, fault.via);
  if (vias.status != Status::kOk) return refuse({vias.status, vias.field, kNoSolid, fault.via});
  const TrackFault of_track = find_track_fault(request.tracks, request.track_count);
  if (of_track.status != Status::kOk) {
    return refuse({of_track.status, Field::kTracks, kNoSolid, kNoVia, of_track.track});
  }
  const Verdict tracks = validate_tracks(request);
  if (tracks.status != Status::kOk) return refuse({tracks.status, tracks.field});
  copy_tracks(request.tracks, request.track_count, memory.tracks, begun_);
  for (std::int32_t v = 0; v < request.via_count; ++v) memory.vias.vias[v] = request.vias[v];
  memory.vias.marks.count = request.via_count;
  problem_.vias = memory.vias.vias;
  problem_.via_count = request.via_count;
  problem_.asked = request;
  problem_.has_pace = request.previous != nullptr || mode.pace != nullptr;
  problem_.pace_from = mode.pace != nullptr ? mode.pace_time : request.previous_time;
  problem_.must_beat_pace = mode.must_beat;
  problem_.given_at_rest = rests(problem_);
  begin_goal();
  if (request.previous != nullptr) problem_.asked.previous = &memory.previous.plan;
  if (mode.pace != nullptr) memory.previous.plan = *mode.pace;
  fault_ = read_world(request, memory.ends, problem_, memory.world, memory.asked, begun_);
  take_things(memory.world.solids, memory.tracks, problem_);
  if (fault_.status != Status::kOk) return refuse(fault_);
  take_ends(problem_, memory.ends);
  return Status::kRunning;
}

Progress Pipeline::advance(Work& work) noexcept {
  const Stage stage = stage_;
  if (!problem_.grid->version().equals(problem_.version)) {
    end(stage, Status::kMapChanged);
    return Progress::kFailed;
  }
  ledger_.begin_slice();
  work.spend(begun_);
  begun_ = 0;
  const Operations left = ledger_.left(stage, problem_.asked.budget) - kept_for_seeds();
  Share slice(work, left);
  Progress progress = run(slice.part);
  if (progress == Progress::kMore && is_full(slice.spent() >= left)) progress = end_for_budget(slice.part);
  ledger_.count(stage, slice.spent(), problem_, static_cast<std::uint32_t>(legs_.choice));
  if (progress != Progress::kMore) go_on(progress == Progress::kDone);
  ledger_.end_slice(stage);
  return progress;
}

/// Begins a stage.
void Pipeline::enter(Stage stage) noexcept {
  Layout& m = *memory_;
  stage_ = stage;
  ledger_.enter();
  switch (stage) {
    case Stage::kSearch:
      begun_ += leg_search_begin(problem_, m.ends, legs_, m.stage.search);
      return;
    case Stage::kShortcut:
      return leg_shortcut_begin(problem_, legs_, way_of(m), m.stage.shortcut);
    case Stage::kCorridor:
      return corridor_begin(m.stage.corridor, m.path, &m.vias.marks, is_around());
    case Stage::kTimes:
      return chain_begin(problem_, m.ends, make_via_joints(problem_, m.vias), pace_of(problem_, curves_, m), m.corridor,
                         m.stage.trajectory);
    case Stage::kTrajectory:
      if (is_around()) {
        const double slack = attempts_.around.seed == 0 ? first_slack(attempts_.around) : 1.0;
        return around_begin(problem_, m.ends, m.stops[0], m.around.seed, slack, m.stage.trajectory);
      }
      begun_ += curves_begin(problem_, m.ends, curves_, m.stage.trajectory);
      return;
    case Stage::kCheck:
      return check_begin(m.stage.check);
    case Stage::kDetour:
      return detour_begin(failure_.status, attempts_.detour);
    case Stage::kPrevious:
      return follow_begin(room_of(problem_, m), attempts_.follow, m.previous);
    case Stage::kStopFirst:
      begin_trajectory(problem_, m.trajectory);
      return stop_first_begin(problem_, attempts_.stop_first, m.stops);
    case Stage::kReach:
      return nearest_point_begin(problem_, leg_target(problem_, legs_), m.stage.reach);
    case Stage::kTracks:
      if (attempts_.around.is_looking || attempts_.around.is_flooding) return;
      return waiting_begin(problem_, m.stops, longest_of(attempts_.around, attempts_.follow), m.trajectory, m.vias,
                           attempts_.waiting);
    case Stage::kRequest:
    case Stage::kWorld:
      break;
  }
}

/// Runs a slice of the current stage.
Progress Pipeline::run(Work& work) noexcept {
  Layout& m = *memory_;
  switch (stage_) {
    case Stage::kWorld:
      return world_advance(m.world, work);
    case Stage::kSearch:
      return leg_search_advance(problem_, m.stage.search, legs_, way_of(m), work);
    case Stage::kShortcut:
      return leg_shortcut_advance(problem_, m.stage.shortcut, legs_, way_of(m), work);
    case Stage::kCorridor:
      return rooms_advance(problem_, m.path, m.stage.corridor, rooms_, m.corridor, work);
    case Stage::kTimes:
      return times_advance(m.stage.trajectory.times, m.stage.trajectory.corridor, work, m.stage.trajectory.chain);
    case Stage::kTrajectory:
      return curves_advance(m.stage.trajectory, curves_, m.trajectory, work);
    case Stage::kCheck:
      return prove_plan(check_query(problem_, m, entered(), follows() || attempts_.follow.leads_plan),
                        attempts_.around.is_waiting ? m.around.alone.corridor : m.corridor, *problem_.grid, m, work);
    case Stage::kDetour:
      return detour_advance(problem_, m.path, work);
    case Stage::kPrevious:
      return follow_advance(room_of(problem_, m), attempts_.follow, m.previous, m.stops[0], work);
    case Stage::kStopFirst:
      return stop_first_advance(problem_, room_of(problem_, m), attempts_.stop_first, m.stops, m.ends, work);
    case Stage::kReach:
      return nearest_point_advance(problem_, m.stage.reach, attempts_.nearest, work);
    case Stage::kTracks:
      if (attempts_.around.is_looking) return look_at_goal(problem_, m.ends, attempts_.around, work);
      if (attempts_.around.is_flooding) {
        return timed_seed_advance(problem_, m.ends, m.stage.flood, m.around.timed, work);
      }
      return look_for_time(work);
    case Stage::kRequest:
      break;
  }
  return Progress::kDone;
}

/// Tries to wait. If that does not help and nothing else is left to try, looks whether the goal is covered.
Progress Pipeline::look_for_time(Work& work) noexcept {
  Trajectory& trajectory = memory_->trajectory;
  const TrackGrounds grounds = tracks_of(problem_);
  Waiting& waiting = attempts_.waiting;
  if (!waiting.is_over) {
    const Progress found = waiting_advance(grounds, trajectory, waiting, work);
    if (found != Progress::kFailed || attempts_.around.is_active) return found;
  }
  if (conflict_.status == Status::kStartInContact) return Progress::kFailed;
  if (!goal_free_.is_sought) goal_free_begin(duration(trajectory), goal_free_);
  TrackProof& proof = memory_->stage.check.at_end;  // no stage needs it now
  const Progress looked = goal_free_advance(grounds, trajectory, goal_free_, conflict_, proof, work);
  return looked == Progress::kMore ? Progress::kMore : Progress::kFailed;
}

/// The current stage has spent its budget. The optimiser then keeps the best plan that it has; other stages fail.
Progress Pipeline::end_for_budget(Work& work) noexcept {
  Layout& m = *memory_;
  switch (stage_) {
    case Stage::kSearch:
      leg_search_stop(problem_, m.stage.search, legs_);
      break;
    case Stage::kShortcut:
      legs_.status = Status::kBudgetShortcut;
      legs_.via = is_last_leg(problem_, legs_) ? kNoVia : legs_.leg;
      break;
    case Stage::kCorridor:
      rooms_.status = Status::kBudgetCorridor;
      rooms_.via = m.stage.corridor.passed < problem_.via_count ? m.stage.corridor.passed : kNoVia;
      break;
    case Stage::kTrajectory:
      trajectory_stop(m.stage.trajectory.stage);
      return run(work);
    case Stage::kReach:
      attempts_.nearest.status = Status::kBudgetSearch;
      break;
    case Stage::kTracks:
      return end_tracks_for_budget();
    case Stage::kRequest:
    case Stage::kWorld:
    case Stage::kTimes:
    case Stage::kCheck:
    case Stage::kDetour:
    case Stage::kPrevious:
    case Stage::kStopFirst:
      break;
  }
  return Progress::kFailed;
}

/// A wait that is clear is taken, though a shorter one may be, too.
Progress Pipeline::end_tracks_for_budget() noexcept {
  Around& around = attempts_.around;
  const bool is_in_time = !around.is_looking && !around.is_flooding;
  if (is_in_time && waiting_stop(memory_->trajectory, attempts_.waiting)) return Progress::kDone;
  around.lacking = Status::kBudgetTracks;
  return Progress::kFailed;
}

}  // namespace tern
