// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/charge.hpp"

#include "map/map_state.hpp"

namespace tern {
namespace {

/// Instructions that a unit stands for.
constexpr std::uint32_t kUnitEffort = 1000;
/// Instructions that a plan takes besides the planner: choosing an aim and a draft, and copies of trajectories.
constexpr std::uint32_t kPlanEffort = 40000;

}  // namespace

Work FlightWork::begin_tick(std::uint32_t units, bool evades) noexcept {
  Work work{units};
  if (!evades) {
    owed += deferred;
    deferred = 0;
  }
  pay(0, work);
  return work;
}

void FlightWork::pay(std::uint32_t effort, Work& work) noexcept {
  owed += effort;
  const std::uint32_t paid = least(owed / kUnitEffort, work.left);
  work.left -= paid;
  owed -= paid * kUnitEffort;
}

void FlightWork::defer_debt() noexcept {
  deferred += owed;
  owed = 0;
}

Progress FlightWork::step(Proof& proof, Work& work) noexcept {
  Status status = Status::kRunning;
  while (status == Status::kRunning) {
    if (work.left == 0) return Progress::kMore;
    const std::uint32_t paid = proof.effort_;
    status = proof.step(1);
    pay(proof.effort_ - paid, work);
  }
  return Progress::kDone;
}

void FlightWork::charge_planner() noexcept {
  planner_paid = 0;
  owed += kPlanEffort;
}

Progress FlightWork::run(Planner& planner, Work& work) noexcept {
  Status status = Status::kRunning;
  while (status == Status::kRunning) {
    if (work.left == 0) return Progress::kMore;
    status = planner.step(1);
    pay(planner.effort() - planner_paid, work);
    planner_paid = planner.effort();
  }
  return Progress::kDone;
}

Status FlightWork::step(YawPlanner& planner, Work& work) noexcept {
  const std::uint32_t effort = planner.unit_effort();
  const Status status = planner.step(1);
  pay(effort, work);
  return status;
}

void FlightWork::step(RollingMap& map, std::uint32_t kept, Work& work) noexcept {
  while (map.busy() && work.left > kept) pay(map.state_->advance(), work);
}

void FlightWork::forget_time(RollingMap& map) noexcept {
  map.state_->timed = false;
}

}  // namespace tern
