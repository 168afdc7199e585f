// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_CLI_FLIGHT_PROGRESS_HPP
#define TERN_CLI_FLIGHT_PROGRESS_HPP

#include <chrono>

#include "host/flight/simulated_flight.hpp"

namespace tern_cli {

/// Shows on a terminal how far a flight is, if its simulation takes longer than a moment. Nothing anywhere else.
class FlightProgress {
 public:
  explicit FlightProgress(const tern_host::FlightWorld& world);

  bool is_shown() const { return is_terminal_; }
  void note(const tern_host::FlightMoment& moment);
  /// Takes the line away.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  const tern_host::FlightWorld& world_;
  bool is_terminal_;
  bool has_line_ = false;
  Clock::time_point due_;
};

}  // namespace tern_cli

#endif
