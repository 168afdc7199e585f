// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The phases that every plan goes through: each runs a slice of its stage and copies what the stage counted into the
// report.
#include "base/math.hpp"
#include "base/work.hpp"
#include "planner/detour.hpp"
#include "planner/escape.hpp"
#include "planner/layout.hpp"
#include "planner/plan.hpp"
#include "trajectory/relative_corridor.hpp"

namespace tern {
namespace {

/// Of a stage that the caller cannot limit.
constexpr std::uint32_t kNoBudget = 0xFFFFFFFFu;

/// A high-water mark: what is done again does not lower it.
void raise(std::int32_t& mark, std::int32_t value) {
  if (mark < value) mark = value;
}

}  // namespace

void Plan::count(Stage stage, std::uint32_t work, std::uint32_t budget, std::uint32_t bound) noexcept {
  StageReport& entry = report_.stages[static_cast<int>(stage)];
  entry.work = before(stage) + work;
  entry.bound = least(budget, bound);
}

/// Takes the fences' voxels from the free ones: one unit for all keep-ins, one a keep-out.
Status Plan::run_fences(Work& work) noexcept {
  Layout& memory = *memory_;
  const Fences& fences = memory.fences;
  for (; fences_blocked_ <= fences.keep_out_count; ++fences_blocked_) {
    if (!work.take()) return Status::kRunning;
    if (fences_blocked_ == 0) {
      block_outside(fences, memory.fence_layer, memory.fenced);
    } else {
      block_keep_out(fences, fences.keep_out[fences_blocked_ - 1], memory.fence_layer, memory.fenced);
    }
    count(Stage::kRequest, static_cast<std::uint32_t>(fences_blocked_) + 1, kNoBudget, kMaxFences + 1);
  }
  enter(Phase::kPath);
  return Status::kOk;
}

Status Plan::run_path(Work& work) noexcept {
  Layout& memory = *memory_;
  PathStage& stage = memory.stage.path;
  const Status status = path_advance(stage, world(), work, memory.path);
  count(Stage::kSearch, stage.expansions, asked_.budget.expansions, searches() * kSearchBound);
  count(Stage::kShortcut, stage.sight_lines, asked_.budget.sight_lines, searches() * (kShortcutBound + kDetourLines));
  raise(report_.high_water.nodes, stage.nodes_high);
  raise(report_.high_water.open, stage.open_high);
  raise(report_.high_water.jump_points, stage.raw_high);
  raise(report_.high_water.segments, stage.segments_high);
  report_.search_used = stage.search_used;
  report_.search_bound = stage.search_bound;
  if (status == Status::kRunning) return status;
  report_.raw_occupied = stage.raw_occupied;
  report_.has_nearest_free = stage.has_nearest_free;
  if (stage.has_nearest_free) report_.nearest_free = stage.nearest_free + world().spec().origin;
  if (status != Status::kOk) return fail(stage.stage, status);
  has_path_ = true;
  enter(Phase::kCorridor);
  return status;
}

Status Plan::run_corridor(Work& work) noexcept {
  Layout& memory = *memory_;
  CorridorStage& stage = memory.stage.corridor;
  const Status status = corridor_advance(stage, world(), memory.path, work, memory.corridor);
  count_planes(stage.planes);
  raise(report_.high_water.planes, stage.planes_high);
  raise(report_.high_water.local_boxes, stage.boxes_high);
  if (status == Status::kRunning) return status;
  if (status == Status::kSegmentsFull) report_.high_water.segments = kMaxSegments;
  // That the detour has no corridor does not make the path's own one unflyable for any other reason.
  if (status != Status::kOk && report_.detours == kDetoured) return fail(Stage::kTrajectory, Status::kNoTrajectory);
  if (status != Status::kOk) return fail(Stage::kCorridor, status);
  report_.half_spaces = 0;
  report_.half_spaces_redundant = 0;
  for (int i = 0; i < memory.corridor.count; ++i) {
    report_.half_spaces += memory.corridor.polyhedra[i].count;
    report_.half_spaces_redundant += memory.corridor.polyhedra[i].redundant;
  }
  has_corridor_ = true;
  enter(Phase::kTimes);
  return status;
}

/// The corridor in the plan's frame, cut into the chain.
void Plan::begin_times() noexcept {
  Layout& memory = *memory_;
  const FlightEnds& ends = memory.ends;
  TrajectoryMemory& stages = memory.stage.trajectory;
  relative_corridor(memory.corridor, ends.origin_in_grid, ends.start.position, ends.goal.position, stages.corridor);
  times_begin(stages.times, stages.corridor, {ends.start, ends.goal, asked_.limits}, stages.chain);
}

Status Plan::run_times(Work& work) noexcept {
  TrajectoryMemory& stages = memory_->stage.trajectory;
  const Status status = times_advance(stages.times, stages.corridor, work, stages.chain);
  count(Stage::kTimes, static_cast<std::uint32_t>(stages.times.timed), kNoBudget, (corridors() + 1) * kTimesBound);
  if (status == Status::kOk) enter(Phase::kTrajectory);
  return status;
}

void Plan::begin_trajectory() noexcept {
  const FlightEnds& ends = memory_->ends;
  TrajectoryMemory& stages = memory_->stage.trajectory;
  const std::uint32_t iterations = stop_and_go_ ? 0 : asked_.budget.iterations - before(Stage::kTrajectory);
  const TrajectoryQuery query{ends.start, ends.goal, asked_.limits, asked_.time_weight, iterations};
  trajectory_begin(stages.stage, stages.corridor, query, stages.chain);
}

Status Plan::run_trajectory(Work& work) noexcept {
  Layout& memory = *memory_;
  TrajectoryStage& stage = memory.stage.trajectory.stage;
  const Status status = trajectory_advance(stage, memory.stage.trajectory.corridor, work, memory.trajectory);
  count(Stage::kTrajectory, stage.iterations, asked_.budget.iterations, corridors() * kTrajectoryBound);
  raise(report_.high_water.active, stage.active_high);
  raise(report_.high_water.qp_iterations, stage.longest_solve);
  raise(report_.high_water.qp_solves, stage.solves);
  if (status == Status::kRunning) return status;
  report_trajectory();
  if (status == Status::kNoTrajectory && report_.detours == 0) {
    enter(Phase::kDetour);
    return status;
  }
  if (status != Status::kOk) return fail(Stage::kTrajectory, status);
  memory.trajectory.origin = asked_.start.position;
  if (!add_escapes(memory.escapes[0], memory.escapes[1], memory.corridor, memory.trajectory)) {
    return stop_and_go_ ? fail(Stage::kTrajectory, Status::kSegmentsFull) : fall_back(Status::kSegmentsFull);
  }
  raise(report_.high_water.segments, memory.trajectory.count);
  enter(Phase::kCheck);
  return status;
}

void Plan::report_trajectory() noexcept {
  const TrajectoryStage& stage = memory_->stage.trajectory.stage;
  report_.quality = stage.quality;
  report_.optimiser = stop_and_go_ ? refused_ : stage.optimiser;
  report_.qp_variables = stage.variables;
  report_.qp_inequalities = stage.inequalities;
  report_.qp_active = stage.active;
  report_.qp_iterations = static_cast<std::int32_t>(report_.stages[static_cast<int>(Stage::kTrajectory)].work);
  report_.kkt_residual = stage.kkt_residual;
}

/// Flies the same corridor from stop to stop: what the optimiser made of it is refused. `why`: kCheckFailed, or
/// kSegmentsFull where an escape leaves no room for so many segments.
Status Plan::fall_back(Status why) noexcept {
  stop_and_go_ = true;
  refused_ = why;
  enter(Phase::kTimes);
  return Status::kOk;
}

Status Plan::run_check(Work& work) noexcept {
  Layout& memory = *memory_;
  CheckStage& stage = memory.stage.check;
  const CheckQuery query{asked_.start, asked_.goal, asked_.limits, has_fences_ ? &memory.asked_fences : nullptr,
                         start_jerk()};
  const Status status = check_advance(stage, world(), memory.corridor, memory.trajectory, query, work);
  count(Stage::kCheck, stage.units, kNoBudget, checks() * kCheckBound);
  if (status == Status::kRunning) return status;
  if (status == Status::kOk || report_.quality != Quality::kOptimised || report_.detours >= kEscaped) {
    return status == Status::kOk ? end(Stage::kCheck, status) : fail(Stage::kCheck, status);
  }
  return fall_back(status);
}

}  // namespace tern
