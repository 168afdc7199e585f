// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One plan, from the copy of the route to the commit. When it begins is known beforehand; late results are dropped.
#include "base/math.hpp"
#include "flight/branch.hpp"
#include "flight/flight_state.hpp"

namespace tern {
namespace {

/// Units of the planner that are paid for together.
constexpr std::uint32_t kPlanSlice = 32;
/// The part of a plan's work that the optimiser may spend: with less it answers with the best plan so far.
constexpr std::uint32_t kIterationShare = 4;
/// A new plan replaces the rest of the one that is flown if it arrives earlier by more than this, seconds.
constexpr double kEarlier = 1e-6;
/// Where plans from rest fail, they are tried in turn with the unseen nearby solid; the same but for voxels next to the
/// vehicle, which may leave it no voxel to begin at; and with the unseen free.
constexpr int kAttempts = 3;
constexpr double kHoleVoxels = 2.0;
/// Ticks from the beginning of a plan to the instant when it takes over.
std::int64_t lead_ticks(const FlightSpec& spec) {
  const std::uint32_t half = spec.work_per_tick / 2;
  return std::int64_t{spec.plan_work / half} + 2;
}

}  // namespace

/// A unit of a proof is a piece of a curve.
Progress FlightState::prove(Work& work) noexcept {
  const std::uint32_t before = proof.report().work;
  const Status status = proof.step(work.left);
  work.left -= proof.report().work - before;
  return status == Status::kRunning ? Progress::kMore : Progress::kDone;
}

/// Nothing to plan for, or nothing to plan on.
void FlightState::begin_cycle() noexcept {
  if (!has_goal || parked || has_next || stopping || watching || !map.safe().bound()) return;
  takeover = time + lead_ticks(spec) * spec.tick;
  deadline = takeover - spec.tick;
  if (reaches_goal() && rests_at_takeover()) return;
  ++report.asked;
  const GridSpec& window = map.route().spec();
  const double near = idle_cycles % kAttempts < 2 ? spec.near : 0.0;
  const double hole = idle_cycles % kAttempts == 1 ? window.radius + kHoleVoxels * window.cell : 0.0;
  route.begin(map, sample_at(takeover).position, near, hole);
  keeps = false;
  job = Job::kCopy;
}

void FlightState::advance(Work& work) noexcept {
  note_rest();
  if (job != Job::kIdle && time > deadline) {
    ++report.dropped;
    give_up();
  }
  const bool in_time = job != Job::kIdle && takeover < contact;
  const bool threatened = threat && !evaded && !in_time;
  if (job != Job::kEvade && !watching && map.safe().bound() && (stopping || threatened)) begin_evade();
  if (job == Job::kIdle) begin_cycle();
  // A cycle has at most as many steps as jobs and candidates.
  constexpr int kSteps = 16 + 2 * kBranches * kBranchShapes;
  Progress progress = Progress::kDone;
  for (int step = 0; step < kSteps && progress == Progress::kDone && job != Job::kIdle; ++step) {
    progress = run_job(work);
  }
}

// One line a job: a table.
// clang-format off
Progress FlightState::run_job(Work& work) noexcept {
  switch (job) {
    case Job::kIdle: return Progress::kMore;
    case Job::kCopy: return run_copy(work);
    case Job::kKeep: return run_keep(work);
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

/// The rest of the plan that is flown is a candidate as long as the vehicle is still on it at the takeover.
Progress FlightState::run_copy(Work& work) noexcept {
  if (route.advance(map, work) == Progress::kMore) return Progress::kMore;
  const double from = seconds_between(now.begin, takeover);
  job = Job::kKeep;
  const bool candidate = now.goal == goal_number && from < now.branch;
  if (!candidate || proof.begin(route.grid(), now.wished, from, nullptr, Beyond::kEmpty) != Status::kRunning) {
    begin_plan();
  }
  return Progress::kDone;
}

Progress FlightState::run_keep(Work& work) noexcept {
  if (prove(work) == Progress::kMore) return Progress::kMore;
  keeps = proof.report().end == ProofEnd::kProven;
  begin_plan();
  return Progress::kDone;
}

/// From where the vehicle will be at the takeover.
void FlightState::begin_plan() noexcept {
  start = joint_at(now.flown, seconds_between(now.begin, takeover), kZero);
  if (keeps && keeps_aim(start.d[0])) {
    aim = now.aim;
    aims_at_goal = now.to_goal;
  } else {
    choose_aim(start.d[0]);
  }
  moved_aim = beside_goal = false;
  ask_planner();
}

void FlightState::ask_planner() noexcept {
  Request request{};
  request.start = {start.d[0], start.d[1], start.d[2], start.d[3]};
  request.goal.position = aim;
  request.limits = spec.limits;
  request.budget.iterations = spec.plan_work / kIterationShare;
  request.time_weight = spec.time_weight;
  planner->begin(route.grid(), request);
  job = Job::kPlan;
}

/// An aim in an obstacle moves to the nearest free point, once. False where that leads nowhere.
bool FlightState::move_aim(const Report& found) noexcept {
  if (found.status != Status::kGoalOccupied || !found.has_nearest_free || moved_aim) return false;
  moved_aim = true;
  aim = found.nearest_free;
  if (is_nearest()) return false;
  const double slack = kAimVoxels * map.route().spec().cell;
  if (keeps && now.beside_goal && distance(now.aim, goal) <= distance(aim, goal) + slack) aim = now.aim;
  beside_goal = aims_at_goal || (keeps && now.beside_goal);
  aims_at_goal = false;
  ask_planner();
  return true;
}

Progress FlightState::run_plan(Work& work) noexcept {
  Status status = Status::kRunning;
  while (status == Status::kRunning) {
    if (work.left < kPlanSlice) return Progress::kMore;
    status = planner->step(kPlanSlice);
    work.left -= kPlanSlice;
  }
  Report found;
  report.plan = planner->finish(plan, found);
  if (!move_aim(found)) choose_draft(report.plan == Status::kOk);
  return Progress::kDone;
}

/// The rest of the plan that is flown wins unless the new one leads elsewhere or arrives earlier.
void FlightState::choose_draft(bool planned) noexcept {
  extends = false;
  if (planned) compose();
  if (keeps) {
    const double rest = duration(now.wished) - seconds_between(now.begin, takeover);
    const bool better = planned && (!same(aim, now.aim) || duration(draft.wished) < rest - kEarlier);
    extends = !better;
  }
  if (extends) draft = now;
  if (!extends && !planned) return fail();
  job = Job::kWait;
}

/// The planner's trajectory, as a draft.
void FlightState::compose() noexcept {
  draft.wished = plan;
  draft.begin = takeover;
  draft.branch = 0.0;
  draft.aim = aim;
  draft.to_goal = aims_at_goal;
  draft.beside_goal = beside_goal;
  draft.goal = goal_number;
}

}  // namespace tern
