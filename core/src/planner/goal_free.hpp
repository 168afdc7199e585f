// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Why no plan is clear in time, for the report: if a thing or a fence covers the goal when a plan arrives, that, and
// from when on the plan could rest there.
#ifndef TERN_PLANNER_GOAL_FREE_HPP
#define TERN_PLANNER_GOAL_FREE_HPP

#include "base/progress.hpp"
#include "base/work.hpp"
#include "planner/moving.hpp"
#include "tern/track.hpp"
#include "tern/track_proof.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// The most times at which the goal is looked at: the steps between them grow to kGoalStep of the time since the
/// arrival, so that these reach kRestHorizon; and then halvings between the last two.
constexpr int kGoalLooks = 256;
constexpr int kGoalHalvings = 14;

struct GoalFree {
  bool is_sought = false;
  bool is_done = false;
  bool is_proving = false;
  int looks = 0;
  int halvings = 0;
  double arrival = 0.0;  ///< s since the plan's beginning
  double at = 0.0;       ///< what is being proven
  double covered = 0.0;  ///< the goal is covered soon after
  double free = __builtin_inf();
};

/// `arrival`: when the plan would rest at the goal.
void goal_free_begin(double arrival, GoalFree& goal) noexcept;

/// Looks at the end of a trajectory to the goal that begins when the plan does: when it arrives, and, if the goal is
/// covered then, later. In that case, `conflict` becomes kGoalCovered, with what covers it last and since when it is
/// covered. A piece of work is one of the proof, which is
/// memory from call to call. kMore or kDone.
Progress goal_free_advance(const TrackGrounds& grounds, const Trajectory& trajectory, GoalFree& goal,
                           Conflict& conflict, TrackProof& proof, Work& work) noexcept;

}  // namespace tern

#endif
