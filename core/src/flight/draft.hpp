// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The draft: the candidate for the next commit, of a cycle or of an evasion, and its proof.
#ifndef TERN_FLIGHT_DRAFT_HPP
#define TERN_FLIGHT_DRAFT_HPP

#include <cstdint>

#include "curve/stopping.hpp"
#include "flight/aim.hpp"
#include "flight/committed_plans.hpp"
#include "flight/flight_facts.hpp"
#include "tern/proof.hpp"
#include "tern/report.hpp"

namespace tern {

/// The most doublings of the lead of plans and brakes.
constexpr int kMostDoublings = 3;

struct Draft {
  Commitment plan;
  bool extends;             ///< `plan` goes on along the planner's plan in flight
  std::int64_t takeover;    ///< when the vehicle begins to follow the draft
  std::int64_t deadline;    ///< the last tick that may commit it
  Proof proof;              ///< of the draft, or of the plan that it is made from
  std::uint64_t proven_on;  ///< the safe grid's revision when that proof began
  Stopping stop;            ///< the brake that was made last

  /// The next commit takes over this number of ticks ahead.
  void begin(const FlightFacts& flight, std::int64_t ticks) noexcept;
  /// Its takeover, and what begins with it, are so many nanoseconds later, or earlier. An extension began before.
  void shift(std::int64_t by) noexcept;
  /// Counts as no extension from now on.
  void clear() noexcept { extends = false; }
  /// Becomes the remainder of the planner's plan in flight.
  void extend(const Commitment& in_flight) noexcept;
  /// Becomes the planner's trajectory.
  void compose(const Aim& aim, const Trajectory& planned, bool hemmed_in, bool looks_out) noexcept;
  /// Becomes a lift from where the vehicle rests at the takeover, straight to a place. `stand` and `ground`: where it
  /// stands before or after it, and the height that the ground there does not exceed.
  void lift(const FlightFacts& flight, const Vec3& to, double speed, const Vec3& stand, double ground) noexcept;
  /// Lists when the planner's trajectory passes the points that it was asked for, and the target if it ends there.
  void list_passages(const Aim& aim, const Report& found, const Trajectory& planned) noexcept;
  /// Follows the planner's plan to its end, which is `until` seconds from its beginning.
  void follow_to_end(double until) noexcept;
  /// The price of branch_off().
  Operations branch_operations(const FlightFacts& flight, int way) const noexcept;
  /// Follows the planner's plan until `at`, then brakes in one of kBranchShapes ways. Among things that move, the first
  /// one is the flat stop: what a thing may do grows with the time that a brake takes. False if there is no such brake.
  bool branch_off(const FlightFacts& flight, double at, int way) noexcept;
  /// Becomes brake number `number` of an evasion. False if there is no such brake.
  bool brake(const FlightFacts& flight, int number, bool evades, Work& work) noexcept;
  /// Leaves the committed plan at the takeover: pushes off to a side, a unit vector, and stops about `far` metres away
  /// from where it would have stopped. False if the limits allow no such motion.
  bool sidestep(const FlightFacts& flight, const Vec3& side, double far, Work& work) noexcept;
  /// Leaves the committed plan, which is at rest at the takeover, straight to a place, world frame, and rests there.
  /// False if the limits allow no such motion.
  bool step_to(const FlightFacts& flight, const Vec3& place, Work& work) noexcept;

  /// Proves that the vehicle may stay where it hovers at the flight's start.
  bool prove_hover(const FlightFacts& flight) noexcept;
  /// Begins to prove a trajectory on the safe grid, from this time on, clear and within the limits.
  Status begin_proof(const FlightFacts& flight, const Trajectory& trajectory, double from) noexcept;
  /// The same with other grounds than grounds_of().
  Status begin_proof(const FlightFacts& flight, double from, Beyond beyond, const ProofGrounds& grounds) noexcept;
  /// Begins to prove the remainder of the planner's plan in flight free on the route copy, and of what is expected of
  /// things that move, from this time on.
  Status begin_proof_of_remainder(const FlightFacts& flight, const Grid& copy, const TrackTable& expected,
                                  double from) noexcept;

  /// Seconds from the draft's beginning to its takeover.
  double start_of_proof() const noexcept;
  /// True if it passes the next point much later than the plan in flight. Right before a point, the planner may find no
  /// better way through it than to stop and come back.
  bool passes_later(const FlightFacts& flight) const noexcept;
  /// Proves that it goes on from the committed plan, without a jump at any joint, and ends at rest. The proofs of
  /// obstacles and limits look at each segment alone.
  bool joins_committed_plan(const CommittedPlans& plans, Work& work) const noexcept;
  bool changes_committed_plan(const CommittedPlans& plans) const noexcept {
    return !extends || plan.branch > plans.in_flight.branch;
  }

 private:
  const Commitment& leave_committed_plan(const FlightFacts& flight, bool evades) noexcept;
  void end_as_brake(const FlightFacts& flight) noexcept;
  bool append_brake(const FlightFacts& flight, const Commitment& committed, int number) noexcept;
};

}  // namespace tern

#endif
