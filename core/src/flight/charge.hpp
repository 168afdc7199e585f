// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a tick spends on: map, planner, proofs and yaw plans spend from one Work, which carries a debt to the next tick.
#ifndef TERN_FLIGHT_CHARGE_HPP
#define TERN_FLIGHT_CHARGE_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "tern/map.hpp"
#include "tern/planner.hpp"
#include "tern/proof.hpp"
#include "tern/yaw.hpp"

namespace tern {

/// Runs proofs and the planner. Alone in a flight, it reaches behind public calls of proofs and the map.
class FlightWork {
 public:
  /// Begins a proof whose fences were checked at the flight's start.
  static Status begin(Proof& proof, const Grid& grid, const Trajectory& trajectory, double from, const Limits* limits,
                      Beyond beyond, const ProofGrounds& grounds) noexcept {
    return proof.begin_accepted(grid, trajectory, from, limits, beyond, grounds);
  }
  /// Runs a proof to its end.
  static Progress step(Proof& proof, Work& work) noexcept {
    return proof.step(work) == Status::kRunning ? Progress::kMore : Progress::kDone;
  }
  /// Runs the planner to the end of its plan or route, whatever it answers.
  static Progress run(Planner& planner, Work& work) noexcept {
    return planner.step(work) == Status::kRunning ? Progress::kMore : Progress::kDone;
  }
  /// The map takes any time for its next frame: the clock was set.
  static void forget_time(RollingMap& map) noexcept;
};

}  // namespace tern

#endif
