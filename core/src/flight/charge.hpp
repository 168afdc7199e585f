// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How a tick spends its units. Work is done piece by piece as long as any of the tick's units are left, and each piece
// is paid for by what it took. If the last piece took more than was left, later ticks pay the rest.
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

/// Runs the planner, proofs, yaw plans and the map a piece at a time, and charges their work to ticks. Alone in a
/// flight, it reaches behind their public calls.
class FlightWork {
 public:
  std::uint32_t owed;          ///< instructions that are done but not paid for yet: a few pieces at most
  std::uint32_t deferred;      ///< instructions to pay for once no evasion is running
  std::uint32_t planner_paid;  ///< how much of the pending plan's effort is paid for, as Planner counts it

  /// The units of a tick, less what earlier ticks owe. While an evasion runs, deferred debt is not paid.
  Work begin_tick(std::uint32_t units, bool evades) noexcept;
  void owe(std::uint32_t effort) noexcept { owed += effort; }
  /// Owes the effort, and pays what is owed as far as the tick's units go.
  void pay(std::uint32_t effort, Work& work) noexcept;
  void defer_debt() noexcept;

  /// Begins a proof whose fences were checked at the flight's start.
  static Status begin(Proof& proof, const Grid& grid, const Trajectory& trajectory, double from, const Limits* limits,
                      Beyond beyond, const ProofGrounds& grounds) noexcept {
    return proof.begin_accepted(grid, trajectory, from, limits, beyond, grounds);
  }
  Progress step(Proof& proof, Work& work) noexcept;
  /// The planner has just begun a plan or a route.
  void charge_planner() noexcept;
  /// Runs the planner to the end of its plan or route, whatever it answers.
  Progress run(Planner& planner, Work& work) noexcept;
  /// One unit of a yaw plan.
  Status step(YawPlanner& planner, Work& work) noexcept;
  /// Runs the map's job until only `kept` units are left.
  void step(RollingMap& map, std::uint32_t kept, Work& work) noexcept;
  /// The map takes any time for its next frame: the clock was set.
  static void forget_time(RollingMap& map) noexcept;
};

}  // namespace tern

#endif
