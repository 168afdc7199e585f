// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One cycle: a plan, from the copy of the route grid to the commit. Its takeover is fixed beforehand; late results are
// dropped.
#include "base/math.hpp"
#include "base/too_narrow.hpp"
#include "flight/branch.hpp"
#include "flight/flight_state.hpp"
#include "grid/distance.hpp"

namespace tern {
namespace {

/// Units of a plan's work for each iteration that the optimiser may spend: if it needs more, it answers with the best
/// plan so far.
constexpr std::uint32_t kUnitsPerIteration = 64;
/// A new plan replaces the rest of the planner's plan in flight if it arrives earlier by more than this, seconds.
constexpr double kEarlier = 1e-6;
/// If plans from rest fail, three kinds of attempt take turns. In the first, unseen voxels nearby are solid. In the
/// second, they are, except next to the vehicle, where they may leave it no voxel to begin at. In the third, they are
/// free. Every kFruitlessAttempt new plans that come no nearer to the goal also bring on the next kind.
constexpr int kAttempts = 3;
constexpr int kFruitlessAttempt = 6;
constexpr double kHoleVoxels = 2.0;
/// Ticks from the start of planning to the takeover. They double for each plan that was dropped before.
std::int64_t lead_ticks(const FlightSpec& spec, int late) {
  const std::uint32_t half = spec.work_per_tick / 2;
  return (std::int64_t{spec.plan_work / half} << (late < kMostDoublings ? late : kMostDoublings)) + 2;
}

}  // namespace

Progress FlightState::prove(Work& work) noexcept {
  return step_proof(proof, work);
}

/// True if the vehicle will rest at the takeover with something within its radius: an error of a sensor, or something
/// that moved. The vehicle may get away from there.
bool FlightState::is_hemmed_in() const noexcept {
  const Grid& safe = map.safe();
  return rests_at_takeover() &&
         !point_clear(safe, safe.to_local(sample_at(takeover).position), safe.spec().clearance());
}

/// Begins a plan, unless there is nothing to plan for, or no map to plan on.
void FlightState::begin_cycle() noexcept {
  if (!has_goal || parked || has_next || stopping || watching || !map.safe().bound()) return;
  takeover = time + lead_ticks(spec, late) * spec.tick;
  deadline = takeover - spec.tick;
  if ((reaches_goal() || ends_at_dwell()) && rests_at_takeover()) return;
  ++report.asked;
  leaves = is_hemmed_in();
  keeps = false;
  seeks && !goes_away() ? begin_lookout() : begin_copy();
}

/// A straight way to a lookout needs no route around unseen voxels. If those were solid, they might leave the vehicle
/// no voxel to begin at.
void FlightState::begin_copy() noexcept {
  const GridSpec& window = map.route().spec();
  int attempt = (idle_cycles + wandering / kFruitlessAttempt) % kAttempts;
  if (seeks) attempt = goes_away() ? 1 : (lookout.is_straight ? 2 : 0);
  const double near = attempt < 2 ? spec.near : 0.0;
  all_free = !(near > 0.0);
  const double hole = attempt == 1 ? window.clearance() + kHoleVoxels * window.cell : 0.0;
  route.begin(map, sample_at(takeover).position, near, hole, leaves ? window.clearance() : 0.0);
  job = Job::kCopy;
}

void FlightState::advance(Work& work) noexcept {
  note_rest();
  if (job != Job::kIdle && time > deadline) {
    ++report.dropped;
    if (job == Job::kEvade) {
      miss_evasion();
    } else {
      ++late;
    }
    give_up();
  }
  const bool is_braking_soon = has_next && next.evades;
  const bool threatened = threat && !evaded && !is_braking_soon && !leaves_time_to_brake();
  const bool watches = watching && watched_part != Watched::kAlarm;
  if (job != Job::kEvade && !watches && map.safe().bound() && (stopping || threatened)) begin_evade();
  if (job == Job::kIdle) begin_cycle();
  note_changed_map();
  // A cycle has at most as many steps as jobs and candidates.
  constexpr int kSteps = 16 + 2 * kBranches * kBranchShapes;
  Progress progress = Progress::kDone;
  for (int step = 0; step < kSteps && progress == Progress::kDone && job != Job::kIdle; ++step) {
    progress = run_job(work);
  }
  if (job == Job::kEvade && time >= deadline) end_evade();  // with the best brake so far
}

// One line a job: a table.
// clang-format off
Progress FlightState::run_job(Work& work) noexcept {
  switch (job) {
    case Job::kIdle: return Progress::kMore;
    case Job::kCopy: return run_copy(work);
    case Job::kKeep: return run_keep(work);
    case Job::kLookout: return run_lookout(work);
    case Job::kRoute: return run_route(work);
    case Job::kPlan: return run_plan(work);
    case Job::kWait: return run_wait();
    case Job::kReach: return run_reach(work);
    case Job::kBranch: return run_branch(work);
    case Job::kConfirm: return run_confirm(work);
    case Job::kEvade: return run_evade(work);
  }
  return Progress::kMore;
}
// clang-format on

/// Copies the route grid, then begins to prove the rest of the planner's plan in flight on it. That rest is a candidate
/// if the takeover comes before the branch.
Progress FlightState::run_copy(Work& work) noexcept {
  while (!route.done()) {
    if (work.left == 0) return Progress::kMore;
    owe(route.advance(map), work);
  }
  const double from = seconds_between(now.begin, takeover);
  job = Job::kKeep;
  const bool candidate = now.goal == goal_number && still_fits() && from < now.branch;
  if (!candidate ||
      proof.begin_accepted(route.grid(), now.wished, from, nullptr, Beyond::kEmpty,
                           {nullptr, nullptr, nullptr, spec.fences, spec.fence_count}) != Status::kRunning) {
    begin_plan();
  }
  return Progress::kDone;
}

Progress FlightState::run_keep(Work& work) noexcept {
  if (prove(work) == Progress::kMore) return Progress::kMore;
  keeps = proof.report().end == ProofEnd::kProven && now.goal == goal_number;
  begin_plan();
  return Progress::kDone;
}

/// Plans from the state of the vehicle at the takeover.
void FlightState::begin_plan() noexcept {
  planned_goal = goal_number;
  start = joint_at(now.flown, seconds_between(now.begin, takeover), kZero);
  moved_aim = beside_goal = to_reachable = false;
  cut_off = cut_off && !all_free;
  if (keeps) keep_points();
  if (keeps && keeps_aim(start.d[0])) {
    aim = now.aim;
    aims_at_goal = now.to_goal;
    looks_out = now.looks_out;
    return ask_planner();
  }
  looks_out = seeks;
  const bool leads_out = leaves && idle_cycles % 2 == 1;
  choose_points(start.d[0]);
  if (leads_out || seeks) ask_for_first(0);
  choose_aim(place_before_target(start.d[0]), leads_out ? spec.horizon : kAnywhere);
  if (seeks) aim_at_lookout();
  if (leads_out) choose_way_out(start.d[0]);
  way_length(start.d[0], aim) > spec.horizon ? ask_route() : ask_planner();
}

/// Asks the planner for a path to the aim.
void FlightState::ask_route() noexcept {
  Request request{};
  request.start.position = start.d[0];
  request.goal.position = aim;
  request.limits = spec.limits;
  request.fences = spec.fences;
  request.fence_count = spec.fence_count;
  request.vias = asked;
  request.via_count = asked_count;
  planner->begin_route(route.grid(), request);
  charge_planner();
  job = Job::kRoute;
}

/// Moves the aim onto the way to the goal, or onto the straight line if there is no way.
Progress FlightState::run_route(Work& work) noexcept {
  Status status = Status::kRunning;
  while (status == Status::kRunning) {
    if (work.left == 0) return Progress::kMore;
    status = step_planner(work);
  }
  Report found;
  if (planner->finish_route(found) == Status::kOk) {
    shorten_way(*planner->path());
    ask_planner();
    return Progress::kDone;
  }
  if (is_outdated()) {
    choose_draft(false);
    return Progress::kDone;
  }
  note_no_plan(found);
  if (note_fault(found)) {
    give_up();
  } else if (lacks_goal_voxel(found.status) && found.has_nearest_free && !moved_aim) {
    moved_aim = true;
    aim = found.nearest_free;
    beside_goal = aims_at_goal;
    aims_at_goal = false;
    ask_route();
  } else if (asked_count > 0) {
    if (!ask_for_less(found)) choose_draft(false);
  } else if (move_to_reachable(found)) {
    return Progress::kDone;
  } else if (cut_off) {
    choose_draft(false);
  } else {
    moved_aim = beside_goal = false;
    choose_aim(start.d[0], spec.horizon);
    ask_planner();
  }
  return Progress::kDone;
}

void FlightState::ask_planner() noexcept {
  Request request{};
  request.start = {start.d[0], start.d[1], start.d[2], start.d[3]};
  request.goal.position = aim;
  request.limits = spec.limits;
  request.budget.iterations = spec.plan_work / kUnitsPerIteration;
  request.time_weight = spec.time_weight;
  request.fences = spec.fences;
  request.fence_count = spec.fence_count;
  request.vias = asked;
  request.via_count = asked_count;
  const double from = seconds_between(now.begin, takeover);
  if (from >= 0.0 && from < now.branch) {
    planner->begin(route.grid(), request, now.wished, from);
  } else {
    planner->begin(route.grid(), request);
  }
  charge_planner();
  job = Job::kPlan;
}

Progress FlightState::run_plan(Work& work) noexcept {
  Status status = Status::kRunning;
  while (status == Status::kRunning) {
    if (work.left == 0) return Progress::kMore;
    status = step_planner(work);
  }
  Report found;
  report.plan = planner->finish(plan, found);
  // Halve the lead again if the plan would have been in time with half of it.
  if (late > 0 && takeover - time > (lead_ticks(spec, late) - lead_ticks(spec, late - 1) + 1) * spec.tick) --late;
  end_plan(found);
  return Progress::kDone;
}

/// If the planner found no plan, asks it for less, if there is anything to leave out.
void FlightState::end_plan(const Report& found) noexcept {
  const bool planned = found.status == Status::kOk;
  if (planned) list_passages(found);
  if (planned || is_outdated()) return choose_draft(planned);
  note_no_plan(found);
  if (note_fault(found)) return give_up();
  if (!move_aim(found) && !move_to_reachable(found) && !ask_for_less(found)) choose_draft(false);
}

/// The rest of the planner's plan in flight wins, unless the new plan leads elsewhere or arrives earlier.
void FlightState::choose_draft(bool planned) noexcept {
  extends = false;
  if (planned) compose();
  if (keeps) {
    const double rest = duration(now.wished) - seconds_between(now.begin, takeover);
    const bool better = planned && (!same(aim, now.aim) || duration(draft.wished) < rest - kEarlier);
    extends = !better || passes_later();
  }
  if (extends) draft = now;
  if (!extends && !planned) return fail();
  job = Job::kWait;
}

/// Makes a draft of the planner's trajectory.
void FlightState::compose() noexcept {
  draft.wished = plan;
  draft.begin = takeover;
  draft.branch = 0.0;
  draft.aim = aim;
  draft.to_goal = aims_at_goal;
  draft.beside_goal = beside_goal;
  draft.goal = planned_goal;
  draft.evades = false;
  draft.leaves = leaves;
  draft.left = start.d[0];
  draft.looks_out = looks_out;
  draft.hidden = seeks ? block.at : now.hidden;
}

}  // namespace tern
