// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a flight committed to, and what of it was withdrawn before it began.
#ifndef TERN_HOST_FLIGHT_COMMIT_LOG_HPP
#define TERN_HOST_FLIGHT_COMMIT_LOG_HPP

#include <cstdint>
#include <utility>
#include <vector>

#include "flight/flight_state.hpp"
#include "host/flight/simulated_flight.hpp"

namespace tern_host {

class CommitLog {
 public:
  /// To be called after every tick, `t` being its time.
  void look(std::int64_t t, const tern::FlightReport& report, const tern::FlightState& state) {
    const bool has_new = report.committed != committed_;
    const bool waits = state.facts.plans.has_waiting && !has_new;
    if (!commits_.empty() && !waits) withdraw(t, commits_.back());
    if (!has_new) return;
    committed_ = report.committed;
    const tern::Commitment& latest = state.facts.plans.latest();
    commits_.push_back({t, latest.begin(), kNotWithdrawn, latest.evades, latest.hemmed_in, latest.trajectory});
  }

  std::vector<FlightCommit> take() { return std::move(commits_); }

 private:
  /// One whose time has come has taken over; it waits no longer, either.
  static void withdraw(std::int64_t t, FlightCommit& commit) {
    if (commit.begin > t && commit.withdrawn == kNotWithdrawn) commit.withdrawn = t;
  }

  std::uint32_t committed_ = 0;
  std::vector<FlightCommit> commits_;
};

}  // namespace tern_host

#endif
