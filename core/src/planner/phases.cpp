// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The planner's phases: one a stage state in the workspace. Each runs a slice of its stage, copies what the stage
// counted into the report, and enters the next phase or ends the plan.
#include "base/math.hpp"
#include "base/work.hpp"
#include "planner/detour.hpp"
#include "planner/layout.hpp"
#include "tern/planner.hpp"
#include "trajectory/stop_and_go.hpp"

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

/// A high-water mark: the detour's stages do not lower it.
void raise(std::int32_t& mark, std::int32_t value) {
  if (mark < value) mark = value;
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
    case Phase::kDetour:
      return Stage::kShortcut;
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
      return path_begin(memory.stage.path, memory.scans, world(), query);
    }
    case Phase::kCorridor:
      return corridor_begin(memory.stage.corridor, world(), memory.path, local_.budget.planes - planes_before_,
                            has_fences_ ? &memory.fences : nullptr);
    case Phase::kCheck:
      return check_begin(memory.stage.check);
    case Phase::kFences:
    case Phase::kTimes:
    case Phase::kTrajectory:
    case Phase::kDetour:
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
    case Phase::kDetour:
      status = run_detour(work);
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
        least(local_.budget.sight_lines, shortcut_bound(stage.query.mode) + (attempts() - 1) * kDetourLines));
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

/// How often corridor and trajectory may be made: a second time where an end moves, after a detour.
std::uint32_t Planner::attempts() const noexcept {
  return at_rest(local_.start) && at_rest(local_.goal) ? 1 : 2;
}

Status Planner::run_corridor(Work& work) noexcept {
  Layout& memory = layout(workspace_);
  CorridorStage& stage = memory.stage.corridor;
  const Status status = corridor_advance(stage, world(), memory.path, work, memory.corridor);
  count(report_, Stage::kCorridor, planes_before_ + stage.planes,
        least(local_.budget.planes, attempts() * kCorridorBound));
  raise(report_.high_water.planes, stage.planes_high);
  raise(report_.high_water.local_boxes, stage.boxes_high);
  if (status == Status::kRunning) return status;
  if (status == Status::kSegmentsFull) report_.high_water.segments = kMaxSegments;
  if (status != Status::kOk) {
    // That the detour has no corridor does not make the path's own one unflyable for any other reason.
    if (report_.detours != 0) return end(Stage::kTrajectory, Status::kNoTrajectory);
    return end(Stage::kCorridor, status);
  }
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

Status Planner::run_times() noexcept {
  Layout& memory = layout(workspace_);
  const TrajectoryQuery query{local_.start, local_.goal, local_.limits, local_.time_weight,
                              local_.budget.iterations - iterations_before_};
  trajectory_begin(memory.stage.trajectory, memory.corridor, query);
  count(report_, Stage::kTimes, static_cast<std::uint32_t>(memory.corridor.count), kMaxSegments);
  enter(Phase::kTrajectory);
  return Status::kOk;
}

Status Planner::run_trajectory(Work& work) noexcept {
  Layout& memory = layout(workspace_);
  TrajectoryStage& stage = memory.stage.trajectory;
  const Status status = trajectory_advance(stage, memory.corridor, work, memory.trajectory);
  const std::uint32_t iterations = iterations_before_ + stage.iterations;
  count(report_, Stage::kTrajectory, iterations, least(local_.budget.iterations, attempts() * kTrajectoryBound));
  raise(report_.high_water.active, stage.active_high);
  raise(report_.high_water.qp_iterations, stage.longest_solve);
  raise(report_.high_water.qp_solves, stage.solves);
  if (status == Status::kRunning) return status;
  report_.quality = stage.quality;
  report_.optimiser = stage.optimiser;
  report_.qp_variables = stage.variables;
  report_.qp_inequalities = stage.inequalities;
  report_.qp_active = stage.active;
  report_.qp_iterations = static_cast<std::int32_t>(iterations);
  report_.kkt_residual = stage.kkt_residual;
  if (status == Status::kNoTrajectory && report_.detours == 0) {
    enter(Phase::kDetour);
    return status;
  }
  if (status != Status::kOk) return end(Stage::kTrajectory, status);
  memory.trajectory.origin = world().spec().origin;
  report_.high_water.segments = memory.trajectory.count;
  enter(Phase::kCheck);
  return status;
}

/// One unit: both ends' detours. Corridor and trajectory begin again with what is left of their budgets.
Status Planner::run_detour(Work& work) noexcept {
  if (!work.take()) return Status::kRunning;
  Layout& memory = layout(workspace_);
  StageReport& shortcut = report_.stages[static_cast<int>(Stage::kShortcut)];
  if (local_.budget.sight_lines - shortcut.work < kDetourLines) return end(Stage::kTrajectory, Status::kNoTrajectory);
  std::uint32_t lines = 0;
  const bool found = take_detour(world(), has_fences_ ? &memory.fences : nullptr, local_, memory.path, lines);
  shortcut.work += lines;
  if (!found) return end(Stage::kTrajectory, Status::kNoTrajectory);
  report_.detours = 1;
  planes_before_ = report_.stages[static_cast<int>(Stage::kCorridor)].work;
  iterations_before_ = report_.stages[static_cast<int>(Stage::kTrajectory)].work;
  has_corridor_ = false;
  enter(Phase::kCorridor);
  return Status::kOk;
}

Status Planner::run_check(Work& work) noexcept {
  Layout& memory = layout(workspace_);
  CheckStage& stage = memory.stage.check;
  const CheckQuery query{local_.start, local_.goal, local_.limits, has_fences_ ? &memory.asked_fences : nullptr};
  const Status status = check_advance(stage, world(), memory.corridor, memory.trajectory, query, work);
  count(report_, Stage::kCheck, stage.units, kCheckBound);
  if (status == Status::kRunning) return status;
  return end(Stage::kCheck, status);
}

}  // namespace tern
