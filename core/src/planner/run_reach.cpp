// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// If no plan leads to the goal: finds the nearest point that a plan can lead to, for the report or as the new goal.
#include "base/progress.hpp"
#include "base/too_narrow.hpp"
#include "base/work.hpp"
#include "curve/rest.hpp"
#include "grid/lattice.hpp"
#include "planner/layout.hpp"
#include "planner/plan.hpp"
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

}  // namespace

/// Nothing else is left to try: ends the plan with its failure. If it missed the goal, the reach stage first finds how
/// near to the goal it could have come.
void Plan::give_up() noexcept {
  if (!report_.has_reachable && misses_goal(failed_status_)) return enter(Stage::kReach);
  end(failed_stage_, failed_status_);
}

/// Looks near the goal itself, not near the point from which the last attempt was to reach the goal.
void Plan::begin_reach() noexcept {
  const Request local = to_local(voxels(), asked_);
  const Vec3 target = leg_ == via_count() ? local.goal.position : leg_to();
  reach_begin(memory_->stage.reach, world(), {local.start.position, target, expansions_left(), !at_rest(asked_.start)});
}

Progress Plan::run_reach(Work& work) noexcept {
  ReachStage& stage = memory_->stage.reach;
  const bool go_there = asked_.goal_mode == GoalMode::kNearest;
  const Progress progress = reach_advance(stage, world(), work);
  count(Stage::kReach, stage.units, asked_.budget.expansions, kReachBound);
  if (progress == Progress::kMore) return progress;
  if (progress == Progress::kFailed) {
    const bool lacks_room = go_there && stage.status != Status::kStartOccupied;
    end(lacks_room ? Stage::kReach : failed_stage_, lacks_room ? stage.status : failed_status_);
    return progress;
  }
  report_.has_reachable = true;
  report_.reachable = reachable_point(stage.nearest);
  const bool at_goal = same(voxels().voxel_of(stage.query.goal), stage.nearest);
  if (go_there && !(at_goal && lacks_nodes(failed_status_))) {
    plan_to_reachable();
  } else {
    end(failed_stage_, failed_status_);
  }
  return progress;
}

/// The voxel's centre in the world, or the start if it rests in that voxel already.
Vec3 Plan::reachable_point(const Voxel& voxel) const noexcept {
  const Grid& grid = voxels();
  const Vec3 start = to_local(voxels(), asked_).start.position;
  const bool stays = at_rest(asked_.start) && same(grid.voxel_of(start), voxel);
  return stays ? asked_.start.position : free_point(grid, voxel) + grid.spec().origin;
}

/// Begins the plan again, with the reachable point as its goal.
void Plan::plan_to_reachable() noexcept {
  report_.goal_missed = failed_status_;
  asked_.goal = {report_.reachable, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
  if (asked_.previous != nullptr) asked_.previous = &memory_->previous.plan;
  begin_attempt();
  begin_with_rest();
}

}  // namespace tern
