// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What one call of the planner answered, and why.
#ifndef TERN_REPORT_HPP
#define TERN_REPORT_HPP

#include <stdint.h>

#include "tern/config.hpp"
#include "tern/diagnostics.hpp"
#include "tern/fence.hpp"
#include "tern/proof_report.hpp"
#include "tern/status.hpp"
#include "tern/track.hpp"
#include "tern/vec3.hpp"
#include "tern/via.hpp"

namespace tern {

/// What kind of plan the trajectory is. Every kind but kNone is a checked plan.
enum class Quality : uint8_t {
  /// There is no plan.
  kNone = 0,
  /// Start equals goal, both at rest: one segment that stays there.
  kHover,
  /// Straight from waypoint to waypoint, coming to rest at each (contract C6). Report::optimiser says why it was not
  /// optimised. Safe, but slower than an optimised plan. If Report::optimiser is kOk, it is an arrival instead: one
  /// curve straight into the motion of the goal.
  kStopAndGo,
  /// The optimiser's plan: minimum snap, traded against duration.
  kOptimised,
  /// The rest of Request::previous, which leads to the goal: that plan itself, from Report::entered on.
  kPrevious,
};

/// Where a plan passes a via.
struct ViaPassage {
  double time;      ///< s since the plan's beginning
  double distance;  ///< m from the via's position then, at most its tolerance but for 1e-9 m
};

/// The whole answer to one call of Planner::plan, finish, route or finish_route, which always fill it. Plain data
/// without pointers.
struct Report {
  /// The answer; the same as the call's return value.
  Status status;
  /// The stage where `status` arose. For kOk: the last stage, kCheck for a plan and kShortcut for a route.
  Stage stage;
  /// The field of the request or grid that is wrong. kNone if no single field is.
  Field field;
  /// Only for kStartOccupied, kGoalOccupied and kViaOccupied. True: the point lies inside an obstacle. False: it is
  /// outside, but closer to one than the radius.
  bool raw_occupied;
  /// Only for kStartOccupied, kGoalOccupied, kViaOccupied, kStartTooNarrow, kGoalTooNarrow and kViaTooNarrow: true if
  /// nearest_free has a value.
  bool has_nearest_free;
  /// True if reachable has a value: the goal is occupied or fenced, or no path leads to it, or the search had no room
  /// to find one (kNodesFull, kOpenFull). False if the start joins no free voxel, if Budget::search did not last,
  /// or if the grid is too large (TERN_MAX_WORLD_WORDS).
  bool has_reachable;
  /// What kind of plan the trajectory is; kNone unless `status` is kOk.
  Quality quality;
  /// How optimising ended. kOk: it finished normally, or was never started. kBudgetOptimise together with kOptimised:
  /// the budget ended it early, and the plan is the best one found until then. With kStopAndGo it says why there is no
  /// optimised plan: kInfeasible, kNumerical, kIterationLimit, kWorkingSetFull, kBudgetOptimise, kSegmentsFull (no room
  /// for so many segments), or kCheckFailed (the check refused the optimised plan; `check` says why). An arrival has
  /// kOk.
  Status optimiser;
  /// Why the plan was to end at `reachable` instead of the goal: kGoalOccupied, kGoalFenced, kNoPath, kNodesFull or
  /// kOpenFull. kOk if it was to end at the goal, and always with GoalMode::kExact.
  Status goal_missed;
  /// The time on the trajectory at which the plan begins, seconds since the trajectory's beginning: `start` of the
  /// request is evaluate(trajectory, entered). Request::previous_time for Quality::kPrevious, else 0. What of the
  /// trajectory lies before is not checked.
  double entered = 0.0;
  /// World frame, metres: the centre of the free voxel nearest to the occupied start, goal or via. Valid if
  /// has_nearest_free is true; zero otherwise.
  Vec3 nearest_free;
  /// World frame, metres: the point nearest to the goal of those that a path leads to. It is the centre of a free
  /// voxel; of centres that are equally near, the one with the least z, then y, then x. If the start is at rest in that
  /// voxel, it is the start. Valid if has_reachable is true; zero otherwise.
  Vec3 reachable;
  /// If `status` is kGoalCovered or kNoClearTime because of a fence for a while: its index in Request::fences.
  /// If `status` or `goal_missed` is kStartFenced, kGoalFenced or kViaFenced: the index in Request::fences of a fence
  /// that is broken. Keep-in fences are looked at first, in the request's order, then keep-out fences. If `field` is
  /// kFences: the index of the fence that is wrong. If `status` or `goal_missed` is kStartTooNarrow, kGoalTooNarrow or
  /// kViaTooNarrow: the index of a fence that blocks the point's voxel, although obstacles and boundary leave it free.
  /// Else kNoFence.
  int32_t fence = kNoFence;
  /// If there is no plan: the index in Request::vias of the via that is wrong, or that no plan leads to. kNoVia if the
  /// fault lies with the start, with the way from the last via to the goal, or with no single part of the way.
  int32_t via = kNoVia;
  /// If `status` is kStartInContact, kGoalCovered or kNoClearTime: the index in Request::tracks of the first one that
  /// the first plan was not proven clear of; for kGoalCovered, of the last one that covers the goal before `goal_free`.
  /// kNoTrack if it is a fence for a while, which `fence` says. If `field` is
  /// kTracks: the index of the track that is wrong. For kOk: the first track that the plan begins too near to, and
  /// leaves. Else kNoTrack.
  int32_t track = kNoTrack;
  /// Seconds since the first plan's beginning. For kStartInContact and kNoClearTime: until then it was proven clear of
  /// all tracks. For kGoalCovered: it has arrived then, and was not proven clear at the goal from then on.
  double conflict = 0.0;
  /// Only for kGoalCovered: a time from which on the goal is proven clear of all tracks for Request::rest_clear
  /// seconds, seconds since the plan's beginning. Shortly before, it is not. Shorter gaps may have been missed.
  /// Infinite if none was found within kRestHorizon.
  double goal_free = __builtin_inf();
  /// Until when the plan's end is proven clear of all tracks, seconds since the trajectory's beginning. Infinite if
  /// that is for longer than kRestHorizon after its end, if there are no tracks, and without a plan.
  double rest_clear_until = __builtin_inf();
  /// Seconds that the plan waits at rest before it sets out, for things that move. A plan that waits may also fly more
  /// slowly than it could.
  double waits = 0.0;
  /// How the plan passes the vias, one entry each. Entries beyond Request::via_count are zero; without a plan, all of
  /// them are. At vias with equal positions, one after the other, several may have the same time.
  ViaPassage vias[kMaxVias];

  /// Only if `status` or `optimiser` is kCheckFailed: what was wrong with the plan that the check refused last. Its
  /// segments are those of that plan, which is not given out.
  ProofReport check;

  /// Only for kStartTooNarrow, kGoalTooNarrow and kViaTooNarrow, metres: the largest edge of a voxel at which this
  /// point is not too narrow, of half the grid's, a quarter and so on, down to 1/64. The grid keeps its origin and
  /// boundary, and its obstacles are marked again. 0 if none of them would do, or no such grid fits.
  double finer_cell;

  /// How the planner came to its answer: work, times, use of capacities.
  Diagnostics diagnostics;
};

}  // namespace tern

#endif
