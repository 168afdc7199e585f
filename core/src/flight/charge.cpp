// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How a tick spends its units. Work is done piece by piece as long as any of the tick's units are left, and each piece
// is paid for by what it took. If the last piece took more than was left, later ticks pay the rest.
#include "base/math.hpp"
#include "flight/flight_state.hpp"
#include "map/map_state.hpp"

namespace tern {
namespace {

/// Instructions that a unit stands for.
constexpr std::uint32_t kUnitEffort = 1000;
/// Instructions that a plan takes besides the planner: choosing an aim and a draft, and copies of trajectories.
constexpr std::uint32_t kPlanEffort = 40000;

}  // namespace

/// The units of this tick, less what earlier ticks owe. While an evasion runs, deferred debt is not paid.
Work FlightState::begin_work() noexcept {
  Work work{spec.work_per_tick};
  if (job != Job::kEvade) {
    owed += deferred;
    deferred = 0;
  }
  owe(0, work);
  return work;
}

void FlightState::owe(std::uint32_t effort, Work& work) noexcept {
  owed += effort;
  const std::uint32_t paid = least(owed / kUnitEffort, work.left);
  work.left -= paid;
  owed -= paid * kUnitEffort;
}

void FlightState::defer_debt() noexcept {
  deferred += owed;
  owed = 0;
}

Progress FlightState::step_proof(Proof& of, Work& work) noexcept {
  Status status = Status::kRunning;
  while (status == Status::kRunning) {
    if (work.left == 0) return Progress::kMore;
    const std::uint32_t paid = of.effort_;
    status = of.step(1);
    owe(of.effort_ - paid, work);
  }
  return Progress::kDone;
}

/// For a plan or a route that the planner has just begun.
void FlightState::charge_planner() noexcept {
  planner_effort = 0;
  owed += kPlanEffort;
}

/// Runs one unit of the planner.
Status FlightState::step_planner(Work& work) noexcept {
  const Status status = planner->step(1);
  owe(planner->effort() - planner_effort, work);
  planner_effort = planner->effort();
  return status;
}

/// The map gets half of the tick's work, or most of it if there is no job.
void FlightState::step_map(Work& work) noexcept {
  if (reads_map()) return;
  if (!map.busy()) follow_window();
  if (!map.busy()) return;
  const std::uint32_t kept = job == Job::kIdle ? work.left / 4 : work.left / 2;
  while (map.busy() && work.left > kept) owe(map.state_->advance(), work);
  // Slide before the next frame begins, because a frame may always be waiting.
  if (!map.busy()) follow_window();
}

}  // namespace tern
