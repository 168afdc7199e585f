// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans that wait until others agree to them.
#include "flight/flight_state.hpp"

namespace tern {

Status FlightState::answer(std::uint32_t number, bool may_fly) noexcept {
  const bool is_last = number != 0 && number == cycle.question;
  if (!is_last || cycle.job != Job::kAnswer) return is_last && !may_fly ? take_back() : Status::kInvalidArgument;
  if (may_fly) {
    cycle.clear();
  } else {
    ++report.failed;
    cycle.leave();
  }
  return Status::kOk;
}

/// The plan that was cleared last is not flown after all. No plan is made while one waits for its takeover, so the one
/// that waits is that one. An extension takes over when it is committed.
Status FlightState::take_back() noexcept {
  if (cycle.job == Job::kCleared || cycle.job == Job::kRenew) {
    leave_question();
    return Status::kOk;
  }
  if (!facts.plans.has_waiting || facts.plans.waiting.evades) return Status::kInvalidArgument;
  ++report.dropped;
  facts.plans.drop_waiting();
  watch.forget_before();
  watch.prove_all();
  return Status::kOk;
}

Status FlightState::set_clearance(std::int64_t clearance) noexcept {
  if (clearance <= 0 || clearance > kLongestTick || facts.spec.clearance == 0) return Status::kInvalidArgument;
  facts.spec.clearance = clearance;
  return Status::kOk;
}

/// Takes the question back. Who answered that the plan may be flown hears that it is not.
void FlightState::leave_question() noexcept {
  const bool is_cleared = cycle.job == Job::kCleared || cycle.job == Job::kRenew;
  if (is_cleared) ++report.dropped;
  if (is_cleared || cycle.job == Job::kAnswer) cycle.leave();
}

Progress FlightState::run_renewal() noexcept {
  if (draft.proof.step(tick_work) == Status::kRunning) return Progress::kMore;
  draft.proof.report().finding == Finding::kNone ? static_cast<void>(commit()) : fail();
  return Progress::kDone;
}

}  // namespace tern
