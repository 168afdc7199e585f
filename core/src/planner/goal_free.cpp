// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/goal_free.hpp"

#include <new>

#include "base/math.hpp"

namespace tern {
namespace {

/// s, and parts of the time since the arrival.
constexpr double kLeastStep = 0.125;
constexpr double kGoalStep = 0.04;
/// s that the goal must be free for at least.
constexpr double kLeastRest = 1e-2;

void prove_from(double at, const TrackGrounds& grounds, const Trajectory& trajectory, GoalFree& goal,
                TrackProof& proof) {
  TrackGrounds resting = grounds;
  resting.leaves = false;
  resting.rest = larger(at - duration(trajectory), 0.0) + larger(grounds.rest, kLeastRest);
  goal.at = at;
  goal.is_proving = true;
  new (&proof) TrackProof;
  proof.begin_accepted(trajectory, larger(at, duration(trajectory)), __builtin_inf(), 0.5 * kTrackTolerance, resting);
}

/// Where to look next; false: the answer is as exact as it gets, or too far away.
bool look_on(bool is_free, double until, GoalFree& goal) {
  if (is_free) {
    goal.free = goal.at;
  } else {
    goal.covered = larger(goal.covered, smaller(until, goal.free));
  }
  if (goal.free - goal.arrival <= kRestHorizon) {
    goal.at = 0.5 * (goal.covered + goal.free);
    return goal.free > goal.arrival && goal.halvings++ < kGoalHalvings;
  }
  const double since = goal.covered - goal.arrival;
  goal.at = goal.covered + larger(kLeastStep, kGoalStep * since);
  return since <= kRestHorizon && ++goal.looks < kGoalLooks;
}

}  // namespace

void goal_free_begin(double arrival, GoalFree& goal) noexcept {
  goal = GoalFree{};
  goal.is_sought = true;
  goal.arrival = goal.covered = goal.at = arrival;
}

Progress goal_free_advance(const TrackGrounds& grounds, const Trajectory& trajectory, GoalFree& goal,
                           Conflict& conflict, TrackProof& proof, Work& work) noexcept {
  for (int k = 0; k <= kGoalLooks + kGoalHalvings && !goal.is_done; ++k) {
    if (!goal.is_proving) {
      if (!work.left()) return Progress::kMore;
      prove_from(goal.at, grounds, trajectory, goal, proof);
    }
    if (proof.step(work) == Status::kRunning) return Progress::kMore;
    goal.is_proving = false;
    const ProofReport& found = proof.report();
    const bool is_free = found.finding == Finding::kNone;
    if (!is_free) {
      const double covered = conflict.status == Status::kGoalCovered ? conflict.until : found.until;
      conflict = {Status::kGoalCovered, found.track, found.fence, covered};
    }
    goal.is_done = !look_on(is_free, found.until, goal);
  }
  return Progress::kDone;
}

}  // namespace tern
