// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The stages that every plan goes through. Each function runs a slice, copies the stage's counts into the report, and
// enters the next stage.
#include "base/math.hpp"
#include "base/progress.hpp"
#include "base/work.hpp"
#include "curve/rest.hpp"
#include "planner/detour.hpp"
#include "planner/escape.hpp"
#include "planner/layout.hpp"
#include "planner/plan.hpp"
#include "trajectory/relative_corridor.hpp"

namespace tern {
namespace {

/// The budget of a stage that the caller cannot limit.
constexpr std::uint32_t kNoBudget = 0xFFFFFFFFu;

}  // namespace

void Plan::count(Stage stage, std::uint32_t work, std::uint32_t budget, std::uint32_t bound) noexcept {
  StageReport& entry = report_.diagnostics.stages[static_cast<int>(stage)];
  entry.work = before(stage) + work;
  entry.bound = least(budget, bound);
}

/// What the stages before the current one have left of Budget::expansions.
std::uint32_t Plan::expansions_left() const noexcept {
  return asked_.budget.expansions - before(Stage::kSearch) - before(Stage::kReach);
}

/// What the stages before the current one have left of Budget::sight_lines.
std::uint32_t Plan::sight_lines_left() const noexcept {
  return asked_.budget.sight_lines - before(Stage::kShortcut) - before(Stage::kDetour);
}

/// What the stages before the current one have left of Budget::planes.
std::uint32_t Plan::planes_left() const noexcept {
  return asked_.budget.planes - before(Stage::kCorridor) - before(Stage::kPrevious) - before(Stage::kEscape);
}

Progress Plan::run_world(Work& work) noexcept {
  const Progress progress = world_advance(memory_->world, work);
  count(Stage::kFences, static_cast<std::uint32_t>(memory_->world.steps), kNoBudget, kWorldBound);
  if (progress == Progress::kMore) return progress;
  if (failed_status_ == Status::kGoalFenced) {
    enter(Stage::kReach);
  } else {
    begin_with_rest();
  }
  return Progress::kDone;
}

void Plan::begin_search() noexcept {
  const FlightEnds& ends = memory_->ends;
  const SearchQuery query{leg_from(),
                          leg_to(),
                          expansions_left(),
                          leg_ == 0 && !at_rest(ends.start),
                          leg_ == via_count() && !at_rest(ends.goal),
                          searched_again_ != 0 ? SearchMode::kOptimal : asked_.search};
  search_begin(memory_->stage.search, memory_->scans, world(), query);
  effort_ += join_effort(memory_->stage.search.start) + join_effort(memory_->stage.search.goal);
}

Progress Plan::run_search(Work& work) noexcept {
  SearchStage& stage = memory_->stage.search;
  const Progress progress = search_advance(stage, world(), work, leg_path());
  count(Stage::kSearch, stage.expansions, asked_.budget.expansions, legs_searched(kSearchBound));
  raise(report_.diagnostics.high_water.nodes, stage.nodes_high);
  raise(report_.diagnostics.high_water.open, stage.open_high);
  raise(report_.diagnostics.high_water.jump_points, stage.raw_high);
  if (leg_ == 0 || stage.search_used == SearchUsed::kGuided) report_.diagnostics.search_used = stage.search_used;
  report_.diagnostics.search_bound =
      leg_ == 0 ? stage.search_bound : larger(report_.diagnostics.search_bound, stage.search_bound);
  if (progress == Progress::kMore) return progress;
  report_.raw_occupied = stage.raw_occupied;
  report_.has_nearest_free = stage.has_nearest_free;
  if (stage.has_nearest_free) report_.nearest_free = stage.nearest_free + voxels().spec().origin;
  if (progress == Progress::kFailed) {
    note_narrowness();
    fail(Stage::kSearch, status_of_leg(stage.status));
  } else {
    enter(Stage::kShortcut);
  }
  return progress;
}

void Plan::begin_shortcut() noexcept {
  shortcut_begin(memory_->stage.shortcut, voxels(), sight_lines_left(), leg_path());
}

Progress Plan::run_shortcut(Work& work) noexcept {
  ShortcutStage& stage = memory_->stage.shortcut;
  const Progress progress = shortcut_advance(stage, voxels(), work, leg_path());
  count(Stage::kShortcut, stage.sight_lines, asked_.budget.sight_lines, legs_searched(kShortcutBound));
  raise(report_.diagnostics.high_water.segments, stage.segments_high);
  if (progress == Progress::kMore) return progress;
  const Status status = progress == Progress::kFailed ? stage.status : join_leg();
  if (status != Status::kOk) {
    if (search_again(status)) return Progress::kDone;
    fail(Stage::kShortcut, status);
    return Progress::kFailed;
  }
  has_path_ = leg_ == via_count();
  if (has_path_ && route_only_) {
    end(Stage::kShortcut, Status::kOk);
  } else if (has_path_) {
    enter(Stage::kCorridor);
  } else {
    ++leg_;
    enter(Stage::kSearch);
  }
  return progress;
}

/// Goes back to the optimal search, once. A fast path may need more segments than fit; a cheapest path often needs
/// fewer.
bool Plan::search_again(Status why) noexcept {
  if (why != Status::kSegmentsFull || report_.diagnostics.search_used != SearchUsed::kGuided) return false;
  searched_again_ = 1;
  begin_way();
  return true;
}

void Plan::begin_corridor() noexcept {
  corridor_begin(memory_->stage.corridor, memory_->path, planes_left(), &memory_->mission.marks);
}

Progress Plan::run_corridor(Work& work) noexcept {
  Layout& memory = *memory_;
  CorridorStage& stage = memory.stage.corridor;
  const Progress progress = corridor_advance(stage, world(), memory.path, work, memory.corridor);
  count(Stage::kCorridor, stage.planes, asked_.budget.planes, (corridors() + searched_again_) * kCorridorBound);
  raise(report_.diagnostics.high_water.planes, stage.planes_high);
  raise(report_.diagnostics.high_water.local_boxes, stage.boxes_high);
  if (progress == Progress::kMore) return progress;
  if (progress == Progress::kFailed) {
    if (report_.diagnostics.detours == 0 && search_again(stage.status)) return Progress::kDone;
    fail_corridor(stage.status);
    return progress;
  }
  has_corridor_ = true;
  enter(Stage::kTimes);
  return progress;
}

void Plan::fail_corridor(Status status) noexcept {
  // If the detour has no corridor, the plan still fails because the path's own corridor has no trajectory.
  if (report_.diagnostics.detours == kDetoured) return fail(Stage::kTrajectory, undetoured_);
  fail(Stage::kCorridor, status);
}

/// The plan that is being flown, if the chain begins on it.
Pace Plan::pace() const noexcept {
  const Layout& memory = *memory_;
  if (!has_pace_ || stop_and_go_ || memory.escapes[0].count > 0) return {};
  return {&memory.previous.plan, pace_from_, memory.previous.plan.origin - asked_.start.position};
}

/// Moves the corridor into the plan's frame and cuts it into the chain.
void Plan::begin_times() noexcept {
  Layout& memory = *memory_;
  const FlightEnds& ends = memory.ends;
  TrajectoryMemory& stages = memory.stage.trajectory;
  make_holds();
  const Holds holds{memory.mission.holds, via_count()};
  relative_corridor(memory.corridor, ends.origin_in_grid, ends.start.position, ends.goal.position, holds,
                    stages.corridor);
  times_begin(stages.times, stages.corridor, {ends.start, ends.goal, limits_, holds, pace()}, stages.chain);
}

Progress Plan::run_times(Work& work) noexcept {
  TrajectoryMemory& stages = memory_->stage.trajectory;
  const Progress progress = times_advance(stages.times, stages.corridor, work, stages.chain);
  count(Stage::kTimes, static_cast<std::uint32_t>(stages.times.timed), kNoBudget,
        (corridors() + attempts()) * kTimesBound);
  if (progress == Progress::kDone) enter(Stage::kTrajectory);
  return progress;
}

void Plan::begin_trajectory() noexcept {
  const FlightEnds& ends = memory_->ends;
  TrajectoryMemory& stages = memory_->stage.trajectory;
  const std::uint32_t iterations = stop_and_go_ ? 0 : asked_.budget.iterations - before(Stage::kTrajectory);
  const TrajectoryQuery query{ends.start, ends.goal, limits_, asked_.time_weight, iterations, stages.times.paced};
  trajectory_begin(stages.stage, stages.corridor, query, stages.chain);
}

Progress Plan::run_trajectory(Work& work) noexcept {
  Layout& memory = *memory_;
  TrajectoryStage& stage = memory.stage.trajectory.stage;
  const Progress progress = trajectory_advance(stage, memory.stage.trajectory.corridor, work, memory.trajectory);
  count(Stage::kTrajectory, stage.iterations, asked_.budget.iterations, corridors() * kTrajectoryBound);
  raise(report_.diagnostics.high_water.active, stage.active_high);
  raise(report_.diagnostics.high_water.qp_iterations, stage.longest_solve);
  raise(report_.diagnostics.high_water.qp_solves, stage.solves);
  if (progress == Progress::kMore) return progress;
  report_trajectory();
  if (progress == Progress::kDone) {
    end_trajectory();
  } else if (report_.diagnostics.detours == 0 && via_count() == 0) {
    undetoured_ = stage.status;
    enter(Stage::kDetour);
  } else {
    fail(Stage::kTrajectory, stage.status);
  }
  return progress;
}

/// Adds the escapes at both ends and the dwells at the vias to the trajectory, and passes it to the check. A chain that
/// has to pass a via in motion has no stop-and-go to fall back to.
void Plan::end_trajectory() noexcept {
  Layout& memory = *memory_;
  memory.trajectory.origin = asked_.start.position;
  if (add_escapes(memory.escapes[0], memory.escapes[1], memory.corridor, memory.trajectory) && add_dwells()) {
    raise(report_.diagnostics.high_water.segments, memory.trajectory.count);
    enter(Stage::kCheck);
  } else if (stop_and_go_ || hurries(memory.stage.trajectory.stage.chain)) {
    fail(Stage::kTrajectory, Status::kSegmentsFull);
  } else {
    fall_back(Status::kSegmentsFull);
  }
}

void Plan::report_trajectory() noexcept {
  const TrajectoryStage& stage = memory_->stage.trajectory.stage;
  report_.quality = stage.quality;
  report_.optimiser = stop_and_go_ ? refused_ : stage.optimiser;
}

/// Replaces the refused plan of the optimiser by stop-and-go along the same corridor. `why`: kCheckFailed, or
/// kSegmentsFull if escapes and dwells leave too little room for its segments.
void Plan::fall_back(Status why) noexcept {
  stop_and_go_ = true;
  refused_ = why;
  enter(Stage::kTimes);
}

Progress Plan::run_check(Work& work) noexcept {
  Layout& memory = *memory_;
  CheckStage& stage = memory.stage.check;
  CheckQuery query{asked_.start, asked_.goal, asked_.limits, memory.world.has_solids ? &memory.asked_fences : nullptr};
  query.start.jerk = start_jerk();
  query.vias = memory.mission.vias;
  query.joints = memory.mission.joint;
  query.via_count = via_count();
  const Progress progress = check_advance(stage, *grid_, memory.corridor, memory.trajectory, query, work);
  count(Stage::kCheck, stage.units, kNoBudget, checks() * kCheckBound);
  if (progress == Progress::kMore) return progress;
  if (tries_rest_) return end_trial(progress == Progress::kDone);
  if (progress == Progress::kDone) {
    report_vias();
    prefers_rest() ? return_to_rest() : static_cast<void>(end(Stage::kCheck, Status::kOk));
    return progress;
  }
  report_.check = stage.found;
  if (report_.quality == Quality::kOptimised && report_.diagnostics.detours < kEscaped) {
    fall_back(stage.status);
  } else {
    fail(Stage::kCheck, stage.status);
  }
  return progress;
}

}  // namespace tern
