// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The costliest tick of each kind.
#ifndef TERN_TESTS_GOLDEN_FLIGHT_TICKS_HPP
#define TERN_TESTS_GOLDEN_FLIGHT_TICKS_HPP

#include <cstdint>

#include "tern/flight.hpp"

namespace tern_golden {

constexpr int kTickKinds = 6;
/// Names of tern::FlightMode, and ticks that commit a plan without a threat.
constexpr const char* kTickNames[kTickKinds] = {"rest tick", "look tick",   "fly tick",
                                                "stop tick", "threat tick", "commit tick"};
constexpr int kCommitTick = 5;

struct TickCosts {
  struct Cost {
    std::uint64_t count = 0;
    std::uint32_t work = 0;  ///< of that tick
  } most[kTickKinds];

  void add(const tern::FlightReport& before, const tern::FlightReport& report, std::uint64_t count) {
    const bool commits = report.committed != before.committed && report.mode != tern::FlightMode::kThreat;
    Cost& cost = most[commits ? kCommitTick : static_cast<int>(report.mode)];
    if (count > cost.count) cost = {count, report.work};
  }
};

}  // namespace tern_golden

#endif
