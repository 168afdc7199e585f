// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One cycle: the pending plan, from the copy of the route grid to a draft whose proof is done. Its takeover is fixed
// beforehand; late results are dropped.
#ifndef TERN_FLIGHT_CYCLE_HPP
#define TERN_FLIGHT_CYCLE_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "flight/aim.hpp"
#include "flight/blocked.hpp"
#include "flight/branch_search.hpp"
#include "flight/charge.hpp"
#include "flight/draft.hpp"
#include "flight/flight_facts.hpp"
#include "flight/itinerary.hpp"
#include "flight/rest_search.hpp"
#include "flight/route_copy.hpp"
#include "tern/planner.hpp"

namespace tern {

/// What the cycle does next.
enum class Job : std::uint8_t {
  kIdle,
  kLookout,    ///< seeks a place from where the sensor may see what blocks the way
  kCopy,       ///< copies the route grid
  kRemainder,  ///< proves the remainder of the planner's plan in flight free on the copy
  kAim,        ///< chooses where the plan leads
  kRoute,      ///< finds the way to the goal; the plan follows its first part
  kPlan,       ///< runs the planner
  kWait,       ///< waits until the window has slid
  kReach,      ///< finds until when the draft is proven
  kBranch,     ///< finds a proven brake that leaves the draft there or earlier
  kConfirm,    ///< proves the draft with its brake as a whole
};

/// What follows a plan that the planner did not find.
enum class NextPlan : std::uint8_t {
  kAsked,    ///< the planner was asked for another one
  kNone,     ///< there is nothing else to ask for
  kNearest,  ///< nor is there: something was seen at the target, and the vehicle is as near to it as it gets
  kCutOff,   ///< nor is there: no way leads to the target, and the vehicle rests as near to it as one leads
};

struct Cycle {
  Job job;
  RouteCopy route;
  Aim aim;
  Trajectory plan;         ///< the planner's trajectory
  int late;                ///< plans that were dropped, one after the other
  bool all_free;           ///< no unseen voxel is solid in the route copy
  bool hemmed_in;          ///< something is within the radius of where the vehicle rests
  bool remainder_is_free;  ///< the remainder of the planner's plan in flight is free on the route copy
  bool looks_out;          ///< the plan leads to a lookout, or to a place on the way to one
  bool cut_off;            ///< no way leads to the target, and the vehicle rests as near to it as it can
  BranchSearch branches;

  void leave() noexcept { job = Job::kIdle; }
  void forget_cut_off() noexcept { cut_off = false; }
  void count_late() noexcept { ++late; }
  /// A new mission begins, with its first point here.
  void expect(const Vec3& first) noexcept { aim.expect(first); }
  /// The job is kLookout if a lookout is to be found, otherwise kCopy.
  void begin(const FlightFacts& flight, const Itinerary& itinerary, const RestSearch& search,
             std::int64_t takeover) noexcept;
  void begin_copy(const FlightFacts& flight, const Itinerary& itinerary, const RestSearch& search,
                  std::int64_t takeover) noexcept;
  /// Copies the route grid, then begins to prove the remainder of the planner's plan in flight on it.
  Progress copy(const FlightFacts& flight, const Itinerary& itinerary, Draft& draft, FlightWork& charge,
                Work& work) noexcept;
  Progress prove_remainder(const FlightFacts& flight, const Itinerary& itinerary, Draft& draft, FlightWork& charge,
                           Work& work) noexcept;
  /// Begins the aim. True if it is that of the plan in flight.
  bool follow_aim(const FlightFacts& flight, const Itinerary& itinerary, std::int64_t takeover) noexcept;
  /// Chooses another aim.
  void choose_aim(const FlightFacts& flight, const Itinerary& itinerary, const RestSearch& search,
                  const Blockage& block, std::int64_t takeover, FlightWork& charge) noexcept;
  /// Asks the planner for a plan to the aim; if the aim is further away than the horizon, for a path to it.
  void ask(const FlightFacts& flight, Planner& planner, std::int64_t takeover, FlightWork& charge) noexcept;
  void ask_plan(const FlightFacts& flight, Planner& planner, std::int64_t takeover, FlightWork& charge) noexcept;
  /// The planner has a path: asks for a plan to the point one horizon along it.
  void follow_route(const FlightFacts& flight, const Itinerary& itinerary, Planner& planner, std::int64_t takeover,
                    FlightWork& charge) noexcept;
  Status finish(Planner& planner, Report& found) noexcept { return planner.finish(plan, found); }
  /// If the plan would have been in time with half of its lead, the next one gets half.
  void shorten_lead(const FlightFacts& flight, std::int64_t takeover) noexcept;
  NextPlan ask_after_no_route(const FlightFacts& flight, const Itinerary& itinerary, const Report& found,
                              Planner& planner, std::int64_t takeover, FlightWork& charge) noexcept;
  NextPlan ask_after_no_plan(const FlightFacts& flight, const Itinerary& itinerary, const Report& found,
                             Planner& planner, std::int64_t takeover, FlightWork& charge) noexcept;
  /// Lists when the planner's trajectory passes the points of the mission, unless there is a new one.
  void list_passages(const Itinerary& itinerary, const Report& found, Draft& draft) noexcept;
  /// Makes the draft: the planner's trajectory, or the remainder of the planner's plan in flight, which wins unless the
  /// new plan leads elsewhere or arrives earlier. False if there is neither. `hidden`: see Commitment.
  bool choose_draft(const FlightFacts& flight, const Itinerary& itinerary, bool planned, const Vec3& hidden,
                    Draft& draft) noexcept;
  /// Waits for the end of a slide, then begins to prove the draft. From here on the map stands still. kFailed if the
  /// draft cannot be proven.
  Progress begin_reach(const FlightFacts& flight, Draft& draft) noexcept;
  /// The draft is proven until then, in seconds since its beginning: looks for a branch there or earlier.
  void begin_branch(double until) noexcept;
  /// Finds a proven branch, then begins to prove the draft as a whole. kFailed if there is no branch.
  Progress find_branch(const FlightFacts& flight, Draft& draft, FlightWork& charge, Work& work) noexcept;
  /// The draft is not proven as a whole: the next candidate follows.
  void reject_branch() noexcept { job = Job::kBranch; }
  /// Proves the draft anew on the map as it is, if it is being proven: boxes were marked meanwhile.
  void prove_anew() noexcept;

  /// Ticks from the beginning of a plan to its takeover.
  std::int64_t lead_ticks(const FlightSpec& spec) const noexcept;
  /// A copy or a proof reads the map, which must not change meanwhile.
  bool reads_map() const noexcept;

 private:
  void ask_route(const FlightFacts& flight, Planner& planner, FlightWork& charge) noexcept;
  void ask_for_less(const FlightFacts& flight, const Itinerary& itinerary, const Report& found, Planner& planner,
                    std::int64_t takeover, FlightWork& charge) noexcept;
  bool may_move_to_reachable(const Report& found) const noexcept;
  bool moves_to_reachable(const FlightFacts& flight, const Report& found, Planner& planner, std::int64_t takeover,
                          FlightWork& charge) noexcept;
};

}  // namespace tern

#endif
