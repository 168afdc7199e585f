// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One cycle: the pending plan, from the copy of the route grid to a draft whose proof is done. Its takeover is fixed
// beforehand; late results are dropped.
#ifndef TERN_FLIGHT_CYCLE_HPP
#define TERN_FLIGHT_CYCLE_HPP

#include <cstddef>
#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "flight/aim.hpp"
#include "flight/branch_search.hpp"
#include "flight/closing.hpp"
#include "flight/draft.hpp"
#include "flight/flight_facts.hpp"
#include "flight/lookouts.hpp"
#include "flight/rest_search.hpp"
#include "flight/route_copy.hpp"
#include "flight/sidestep.hpp"
#include "tern/planner.hpp"

namespace tern {

/// What the cycle does next.
enum class Job : std::uint8_t {
  kIdle,
  kCopy,       ///< copies the route grid
  kFollow,     ///< checks whether the remainder of the planner's plan in flight is a candidate
  kRemainder,  ///< proves that remainder free on the copy
  kAim,        ///< chooses where the plan leads
  kAskRoute,   ///< asks the planner for a route to the aim
  kRoute,      ///< finds the route; the plan then follows its first part
  kAskPlan,    ///< asks the planner for a plan to the aim
  kPlan,       ///< finds the plan
  kWait,       ///< waits until the window has slid
  kProve,      ///< finds until when the draft is proven
  kBranch,     ///< finds a proven brake that leaves the draft there or earlier
  kConfirm,    ///< proves the draft with its brake as a whole
  kAnswer,     ///< waits for the answer whether the draft may be flown
  kCleared,    ///< it may: waits until the window has slid
  kRenew,      ///< proves the draft once more, on the map as it is now
  kSidestep,   ///< finds a proven way out of the way of a thing
};

/// The next question to the planner after it found no plan.
enum class NextPlan : std::uint8_t {
  kAsked,    ///< the planner is asked for another plan next
  kNone,     ///< nothing: there is nothing else to ask for
  kNearest,  ///< nothing: something was seen at the target, and the vehicle is as near to it as it gets
  kCutOff,   ///< nothing: no way leads to the target, and the vehicle rests as near to it as a way leads
};

/// How long before its takeover a plan begins.
struct Lead {
  int late;  ///< plans in a row that were late

  /// Ticks before the takeover. Each late plan doubles them, up to kMostDoublings times.
  std::int64_t ticks(const FlightSpec& spec) const noexcept;
  void note_late() noexcept { ++late; }
  /// A plan for this takeover is done: if half of its lead would have been enough, the next one gets half.
  void shorten(const FlightFacts& flight, std::int64_t takeover) noexcept;
};

/// Cycles after one that found no way on a copy with walls.
constexpr int kCyclesWithoutWalls = 15;

struct Cycle {
  Planner* planner;  ///< the caller's
  Lead lead;
  RouteCopy route;
  Aim aim;
  Trajectory plan;  ///< the planner's trajectory
  Job job;
  bool all_free;             ///< no unseen voxel is solid in the route copy
  int without_walls;         ///< so many cycles take a copy in which nothing is presumed above and below walls
  bool is_last_resort;       ///< the vehicle rests and looks around, because nothing else helped
  bool hemmed_in;            ///< something is within the radius of where the vehicle rests
  bool leads_out;            ///< the plan leads away from what is within the radius
  bool steps_back;           ///< this cycle looks for a sidestep back to where a plan can begin
  bool remainder_is_free;    ///< the remainder of the planner's plan in flight is free on the route copy
  bool must_beat;            ///< the plan that was asked for leads where that remainder does, and has to be better
  bool looks_out;            ///< the plan leads to a lookout, or to a place on the way to one
  std::uint32_t question;    ///< number of the last draft that waits, or waited, for an answer
  bool cut_off;              ///< no way leads to the target, and the vehicle rests as near to it as it can
  std::uint32_t met_things;  ///< plans in a row that failed because of what moves, or a fence for a while
  std::int32_t closing;      ///< the fence that is about to begin where the vehicle rests, or will; kNoFence: none
  std::uint32_t closings;    ///< cycles in a row for which there was one
  bool leaves_fence;         ///< the plan leads out of it
  Fence routed[kMaxFences];  ///< for routes: keep-outs that are closed, or soon will be, are closed at all times
  bool has_closed;           ///< the route leads around some of these
  BranchSearch branches;
  Sidesteps sidesteps;
  bool gave_way;        ///< this cycle looks for a sidestep. The next one makes a plan
  TrackTable expected;  ///< what things that move are expected to do: the plan keeps clear of that

  void leave() noexcept {
    job = Job::kIdle;
    steps_back = false;
  }
  /// No way was found on a copy with walls: the next copies, which begin at once, go without.
  void do_without_walls() noexcept {
    without_walls = kCyclesWithoutWalls;
    leave();
  }
  void forget_cut_off() noexcept { cut_off = false; }
  void begin(const FlightFacts& flight, const RestSearch& search, const Lookouts& lookouts, std::int64_t takeover,
             Work& work) noexcept;
  /// The draft is a lift: only its proof is left to do.
  void begin_lift(const FlightFacts& flight, std::int64_t takeover) noexcept;
  /// Begins to look for a sidestep, if the vehicle is in the way of something at this takeover. False if it is not, or
  /// if the last cycle looked for one.
  bool begin_sidestep(const FlightFacts& flight, Draft& draft, Work& work) noexcept;
  /// Begins to look for one that leads back to where a plan can begin, if none can where the vehicle will rest at this
  /// takeover, so that it gets to no lookout.
  bool begin_step_back(const FlightFacts& flight, const RestSearch& search, const Lookouts& lookouts, Draft& draft,
                       Work& work) noexcept;
  Progress copy(const RollingMap& map, Work& work) noexcept;
  /// Begins to prove the remainder of the planner's plan in flight on the copy, if it is a candidate.
  Progress begin_remainder(const FlightFacts& flight, Draft& draft) noexcept;
  Progress prove_remainder(const FlightFacts& flight, Draft& draft, Work& work) noexcept;
  /// Chooses the aim of the plan in flight, if that is still good enough. False if another one is to be chosen.
  bool follow_aim(const FlightFacts& flight, const Lookouts& lookouts, std::int64_t takeover) noexcept;
  /// Chooses another aim.
  void choose_aim(const FlightFacts& flight, const Lookouts& lookouts, std::int64_t takeover, Work& work) noexcept;
  Progress ask_route(const FlightFacts& flight, Work& work) noexcept;
  /// No route leads around what is closed: asks for one through it. False if nothing is closed.
  bool ask_through(const FlightFacts& flight) noexcept;
  /// The fence that keeps a vehicle from resting where the draft ends; kNoFence: none.
  std::int32_t fence_at_end(const FlightFacts& flight, const Draft& draft, Work& work) const noexcept;
  /// kFailed if the vehicle rests, and things leave it no place to go to.
  Progress ask_plan(const FlightFacts& flight, std::int64_t takeover, Work& work) noexcept;
  /// How far ahead the next plan leads, m. Each plan in a row that failed because of things that move leads half as far
  /// as the one before, down to an eighth of FlightSpec::horizon; then the next one leads all of it again.
  double horizon(const FlightFacts& flight) const noexcept;
  /// The planner is done. `found` says what it found.
  Status finish(Report& found) noexcept;
  /// True if it found nothing better than the remainder of its plan in flight.
  bool keeps_remainder(const Report& found) const noexcept;
  /// The route that was found.
  FoundRoute route_found() const noexcept;
  /// The route is found: the plan leads to the point one horizon along it.
  void follow_route(const FlightFacts& flight) noexcept;
  /// No route, or no plan, was found: changes the aim, and asks for another one, if there is anything else to ask for.
  NextPlan next_after_route(const FlightFacts& flight, const Report& found, std::int64_t takeover) noexcept;
  NextPlan next_after_plan(const FlightFacts& flight, const Report& found, std::int64_t takeover) noexcept;
  /// Lists when the planner's trajectory passes the points of the mission, unless there is a new mission.
  void list_passages(const FlightFacts& flight, const Report& found, Draft& draft) noexcept;
  /// Makes the draft: the planner's trajectory, or the remainder of the planner's plan in flight. The remainder wins
  /// unless the new plan leads elsewhere or arrives earlier, and does not pass the next point much later. False if
  /// there is neither.
  bool choose_draft(const FlightFacts& flight, bool planned, Draft& draft) noexcept;
  /// Waits for the end of a slide, then begins to prove the draft. From here on the map stands still. kFailed if the
  /// draft cannot be proven.
  Progress begin_proof(const FlightFacts& flight, Draft& draft) noexcept;
  /// Looks for a branch at `until` or earlier: the draft is proven until then, in seconds since its beginning.
  void begin_branch(double until) noexcept;
  /// Finds a proven branch, then begins to prove the draft as a whole. kFailed if there is no branch.
  Progress find_branch(const FlightFacts& flight, Draft& draft, Work& work) noexcept;
  /// The draft is not proven as a whole: the next candidate follows.
  void reject_branch() noexcept { job = Job::kBranch; }
  /// The draft is proven, and needs an answer whether it may be flown.
  void ask_for_clearance() noexcept;
  /// It may be flown.
  void clear() noexcept { job = Job::kCleared; }
  /// Waits for the end of a slide, then begins to prove the draft once more. kFailed if it cannot be proven.
  Progress begin_renewal(const FlightFacts& flight, Draft& draft) noexcept;
  /// Boxes were marked. If the draft is being proven, its proof begins anew on the map as it is now.
  void prove_anew() noexcept;

  /// The draft is no plan, but a sidestep.
  bool is_sidestep() const noexcept { return gave_way || steps_back; }
  /// A copy or a proof reads the map, which must not change meanwhile.
  bool reads_map() const noexcept;
  /// The draft is being proven, with the tubes that it has now.
  bool proves_draft() const noexcept { return job == Job::kProve || job == Job::kBranch || job == Job::kConfirm; }
  /// False while it looks for a sidestep, and while others look at the plan: what is late then is no plan.
  bool is_planning() const noexcept {
    return job != Job::kSidestep && job != Job::kAnswer && job != Job::kCleared && job != Job::kRenew;
  }

 private:
  void prove_sidesteps(const FlightFacts& flight, Draft& draft) noexcept;
  void ask(const FlightFacts& flight) noexcept;
  void note_closing(const FlightFacts& flight, Work& work) noexcept;
  Vec3 way_out(const FlightFacts& flight, Work& work) const noexcept;
  void close_fences(const FlightFacts& flight, std::int64_t takeover, Work& work) noexcept;
  NextPlan ask_for_less(const FlightFacts& flight, const Report& found) noexcept;
  bool may_move_to_reachable(const Report& found) const noexcept;
  bool moves_to_reachable(const FlightFacts& flight, const Report& found, std::int64_t takeover) noexcept;
};

}  // namespace tern

#endif
