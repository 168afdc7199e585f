// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a flight does behind the public calls of proofs and of the map.
#ifndef TERN_FLIGHT_FLIGHT_ACCESS_HPP
#define TERN_FLIGHT_FLIGHT_ACCESS_HPP

#include "tern/map.hpp"
#include "tern/proof.hpp"

namespace tern {

/// Alone in a flight, it is a friend of theirs.
class FlightAccess {
 public:
  /// Begins a proof whose grounds were checked at the flight's start.
  static Status begin(Proof& proof, const Grid& grid, const Trajectory& trajectory, double from, const Limits* limits,
                      Beyond beyond, const ProofGrounds& grounds) noexcept {
    return proof.begin_accepted(grid, trajectory, from, limits, beyond, grounds);
  }
  /// The map takes any time for its next frame: the clock was set.
  static void forget_time(RollingMap& map) noexcept;
};

}  // namespace tern

#endif
