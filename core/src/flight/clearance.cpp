// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans that wait until others agree to them.
#include "flight/flight_state.hpp"

namespace tern {

Status FlightState::answer(std::uint32_t number, bool may_fly) noexcept {
  if (cycle.job != Job::kAnswer || number != cycle.question) return Status::kInvalidArgument;
  if (may_fly) {
    cycle.clear();
  } else {
    ++report.failed;
    cycle.leave();
  }
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
