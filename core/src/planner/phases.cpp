// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The planner's phases: one a stage state in the workspace. Each runs a slice of its stage, copies what the stage
// counted into the report, and enters the next phase or ends the plan.
#include "base/math.hpp"
#include "base/work.hpp"
#include "planner/layout.hpp"
#include "tern/planner.hpp"

namespace tern {
namespace {

Layout& layout(void* workspace) {
  return *static_cast<Layout*>(workspace);
}

void count(Report& report, Stage stage, std::uint32_t work, std::uint32_t bound) {
  StageReport& entry = report.stages[static_cast<int>(stage)];
  entry.work = work;
  entry.bound = bound;
}

std::uint32_t least(std::uint32_t a, std::uint32_t b) {
  return b < a ? b : a;
}

}  // namespace

Stage Planner::stage_of_phase() const noexcept {
  switch (phase_) {
    case Phase::kFences:
      return Stage::kRequest;
    case Phase::kPath:
      return static_cast<const Layout*>(workspace_)->stage.path.stage;
    case Phase::kCorridor:
      return Stage::kCorridor;
    case Phase::kTimes:
      return Stage::kTimes;
    case Phase::kTrajectory:
      return Stage::kTrajectory;
    case Phase::kCheck:
      return Stage::kCheck;
    case Phase::kIdle:
    case Phase::kDone:
      break;
  }
  return Stage::kRequest;
}

void Planner::enter(Phase phase) noexcept {
  Layout& memory = layout(workspace_);
  phase_ = phase;
  switch (phase) {
    case Phase::kPath: {
      const PathQuery query{local_.start.position,     local_.goal.position,
                            local_.shortcut,           local_.budget.expansions,
                            local_.budget.sight_lines, has_fences_ ? &memory.fences : nullptr};
      return path_begin(memory.stage.path, world(), query);
    }
    case Phase::kCorridor:
      return corridor_begin(memory.stage.corridor, world(), memory.path, local_.budget.planes,
                            has_fences_ ? &memory.fences : nullptr);
    case Phase::kCheck:
      return check_begin(memory.stage.check);
    case Phase::kFences:
    case Phase::kTimes:
    case Phase::kTrajectory:
    case Phase::kIdle:
    case Phase::kDone:
      break;
  }
}

Status Planner::run_phase(Work& work) noexcept {
  const Stage stage = stage_of_phase();
  const std::uint64_t before = clock_ != nullptr ? clock_(clock_context_) : 0;
  Status status = Status::kRunning;
  switch (phase_) {
    case Phase::kFences:
      status = run_fences(work);
      break;
    case Phase::kPath:
      status = run_path(work);
      break;
    case Phase::kCorridor:
      status = run_corridor(work);
      break;
    case Phase::kTimes:
      status = run_times();
      break;
    case Phase::kTrajectory:
      status = run_trajectory(work);
      break;
    case Phase::kCheck:
      status = run_check(work);
      break;
    case Phase::kIdle:
    case Phase::kDone:
      break;
  }
  const std::uint64_t after = clock_ != nullptr ? clock_(clock_context_) : 0;
  // A clock that runs backwards says nothing; the plan does not depend on it.
  if (after < before) report_.timing_known = false;
  report_.stages[static_cast<int>(stage)].ticks += after - before;
  return status;
}

/// Takes the fences' voxels from the free ones: one unit for all keep-ins, one a keep-out.
Status Planner::run_fences(Work& work) noexcept {
  Layout& memory = layout(workspace_);
  const Fences& fences = memory.fences;
  for (; fences_blocked_ <= fences.keep_out_count; ++fences_blocked_) {
    if (!work.take()) return Status::kRunning;
    if (fences_blocked_ == 0) {
      block_outside(fences, memory.fence_layer, memory.fenced);
    } else {
      block_keep_out(fences, fences.keep_out[fences_blocked_ - 1], memory.fence_layer, memory.fenced);
    }
    count(report_, Stage::kRequest, static_cast<std::uint32_t>(fences_blocked_) + 1, kMaxFences + 1);
  }
  enter(Phase::kPath);
  return Status::kOk;
}

Status Planner::run_path(Work& work) noexcept {
  Layout& memory = layout(workspace_);
  PathStage& stage = memory.stage.path;
  const Status status = path_advance(stage, world(), work, memory.path);
  count(report_, Stage::kSearch, stage.expansions, least(local_.budget.expansions, kSearchBound));
  count(report_, Stage::kShortcut, stage.sight_lines,
        least(local_.budget.sight_lines, shortcut_bound(stage.query.mode)));
  report_.high_water.nodes = stage.nodes_high;
  report_.high_water.heap = stage.heap_high;
  report_.high_water.jump_points = stage.raw_high;
  report_.high_water.segments = stage.segments_high;
  if (status == Status::kRunning) return status;
  if (status != Status::kOk) {
    report_.raw_occupied = stage.raw_occupied;
    report_.has_nearest_free = stage.has_nearest_free;
    if (stage.has_nearest_free) report_.nearest_free = stage.nearest_free + world().spec().origin;
    return end(stage.stage, status);
  }
  has_path_ = true;
  enter(Phase::kCorridor);
  return status;
}

Status Planner::run_corridor(Work& work) noexcept {
  Layout& memory = layout(workspace_);
  CorridorStage& stage = memory.stage.corridor;
  const Status status = corridor_advance(stage, world(), memory.path, work, memory.corridor);
  count(report_, Stage::kCorridor, stage.planes, least(local_.budget.planes, kCorridorBound));
  report_.high_water.planes = stage.planes_high;
  report_.high_water.local_boxes = stage.boxes_high;
  if (status == Status::kRunning) return status;
  if (status == Status::kSegmentsFull) report_.high_water.segments = kMaxSegments;
  if (status != Status::kOk) return end(Stage::kCorridor, status);
  for (int i = 0; i < memory.corridor.count; ++i) {
    report_.half_spaces += memory.corridor.polyhedra[i].count;
    report_.half_spaces_redundant += memory.corridor.polyhedra[i].redundant;
  }
  has_corridor_ = true;
  enter(Phase::kTimes);
  return status;
}

Status Planner::run_times() noexcept {
  Layout& memory = layout(workspace_);
  const TrajectoryQuery query{local_.start, local_.goal, local_.limits, local_.time_weight, local_.budget.iterations};
  trajectory_begin(memory.stage.trajectory, memory.corridor, query);
  count(report_, Stage::kTimes, static_cast<std::uint32_t>(memory.corridor.count), kMaxSegments);
  enter(Phase::kTrajectory);
  return Status::kOk;
}

Status Planner::run_trajectory(Work& work) noexcept {
  Layout& memory = layout(workspace_);
  TrajectoryStage& stage = memory.stage.trajectory;
  const Status status = trajectory_advance(stage, memory.corridor, work, memory.trajectory);
  count(report_, Stage::kTrajectory, stage.iterations, least(local_.budget.iterations, kTrajectoryBound));
  report_.high_water.active = stage.active_high;
  report_.high_water.qp_iterations = stage.longest_solve;
  report_.high_water.qp_solves = stage.solves;
  if (status == Status::kRunning) return status;
  report_.quality = stage.quality;
  report_.optimiser = stage.optimiser;
  report_.qp_variables = stage.variables;
  report_.qp_inequalities = stage.inequalities;
  report_.qp_active = stage.active;
  report_.qp_iterations = static_cast<std::int32_t>(stage.iterations);
  report_.kkt_residual = stage.kkt_residual;
  if (status != Status::kOk) return end(Stage::kTrajectory, status);
  memory.trajectory.origin = world().spec().origin;
  report_.high_water.segments = memory.trajectory.count;
  enter(Phase::kCheck);
  return status;
}

Status Planner::run_check(Work& work) noexcept {
  Layout& memory = layout(workspace_);
  CheckStage& stage = memory.stage.check;
  const CheckQuery query{local_.start, local_.goal, local_.limits, has_fences_ ? &memory.fences : nullptr};
  const Status status = check_advance(stage, world(), memory.corridor, memory.trajectory, query, work);
  count(report_, Stage::kCheck, stage.units, kCheckBound);
  if (status == Status::kRunning) return status;
  return end(Stage::kCheck, status);
}

}  // namespace tern
