// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The attempt that remains if no plan leads to the goal: finds the nearest point that a plan can lead to, for the
// report or as the new goal.
#ifndef TERN_PLANNER_NEAREST_POINT_HPP
#define TERN_PLANNER_NEAREST_POINT_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "path/reach_stage.hpp"
#include "planner/problem.hpp"
#include "tern/status.hpp"
#include "tern/vec3.hpp"

namespace tern {

struct NearestPoint {
  bool has_point;
  Vec3 point;          ///< the reachable point, world frame
  Status goal_missed;  ///< why the plan leads there; kOk if it does not
  Status status;       ///< why the stage failed; else kOk
};

/// True if no limits and no budget would lead the plan to the goal, and the reachable point is not known yet.
bool nearest_point_may_help(const NearestPoint& nearest, Status failure) noexcept;

/// Looks for the point nearest to `target` (local frame).
void nearest_point_begin(const Problem& problem, const Vec3& target, ReachStage& stage) noexcept;
/// The pieces of work are those of reach_advance. kDone: nearest.point is known.
Progress nearest_point_advance(const Problem& problem, ReachStage& stage, NearestPoint& nearest, Work& work) noexcept;

/// True if the plan should lead to the point that was found. It should not if the point lies in the goal's own voxel:
/// then the search only lacked memory.
bool leads_to_nearest(const Problem& problem, const ReachStage& stage, Status failure) noexcept;

/// Makes the reachable point the goal. `failure` says why.
void make_nearest_the_goal(Status failure, NearestPoint& nearest, Problem& problem) noexcept;

}  // namespace tern

#endif
