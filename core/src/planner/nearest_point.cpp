// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/nearest_point.hpp"

#include "base/direction.hpp"
#include "base/math.hpp"
#include "base/too_narrow.hpp"
#include "curve/rest.hpp"
#include "grid/lattice.hpp"
#include "planner/validate.hpp"

namespace tern {
namespace {

/// The search ran out of memory before it could tell whether there is a path.
bool lacks_nodes(Status status) {
  return status == Status::kNodesFull || status == Status::kOpenFull;
}

/// The goal cannot be planned to, whatever the limits and the budget.
bool misses_goal(Status status) {
  return lacks_goal_voxel(status) || status == Status::kGoalFenced || status == Status::kNoPath ||
         lacks_via_voxel(status) || lacks_nodes(status);
}

/// The voxel's centre in the world, or the start if it rests in that voxel already.
Vec3 reachable_point(const Problem& problem, const Voxel& voxel) {
  const Grid& grid = voxels_of(problem);
  const State& start = problem.asked.start;
  const bool stays = at_rest(start) && same(grid.voxel_of(to_local(grid, start.position)), voxel);
  return stays ? start.position : free_point(grid, voxel) + grid.spec().origin;
}

}  // namespace

bool nearest_point_may_help(const NearestPoint& nearest, Status failure) noexcept {
  return !nearest.has_point && misses_goal(failure);
}

void nearest_point_begin(const Problem& problem, const Vec3& target, ReachStage& stage) noexcept {
  const State& start = problem.asked.start;
  reach_begin(stage, world_of(problem), {to_local(voxels_of(problem), start.position), target, !at_rest(start)});
}

Progress nearest_point_advance(const Problem& problem, ReachStage& stage, NearestPoint& nearest, Work& work) noexcept {
  const Progress progress = reach_advance(stage, world_of(problem), work);
  nearest.status = stage.status;
  if (progress != Progress::kDone) return progress;
  nearest.has_point = true;
  nearest.point = reachable_point(problem, stage.nearest);
  return progress;
}

bool leads_to_nearest(const Problem& problem, const ReachStage& stage, Status failure) noexcept {
  if (problem.asked.goal_mode != GoalMode::kNearest) return false;
  return !same(voxels_of(problem).voxel_of(stage.query.goal), stage.nearest) || !lacks_nodes(failure);
}

void make_nearest_the_goal(Status failure, NearestPoint& nearest, Problem& problem) noexcept {
  nearest.goal_missed = failure;
  problem.asked.goal = {nearest.point, kZero, kZero};
}

}  // namespace tern
