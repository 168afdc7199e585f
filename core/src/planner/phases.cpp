// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which phase follows which: each runs a slice of its stage and enters the next one, or ends the plan.
#include "base/work.hpp"
#include "curve/rest.hpp"
#include "planner/layout.hpp"
#include "planner/plan.hpp"

namespace tern {
Stage Plan::stage_of_phase() const noexcept {
  switch (phase_) {
    case Phase::kFences:
      return Stage::kRequest;
    case Phase::kPath:
      return memory_->stage.path.stage;
    case Phase::kCorridor:
      return Stage::kCorridor;
    case Phase::kTimes:
      return Stage::kTimes;
    case Phase::kTrajectory:
      return Stage::kTrajectory;
    case Phase::kDetour:
      return Stage::kShortcut;
    case Phase::kPrevious:
    case Phase::kEscape:
      return Stage::kCorridor;
    case Phase::kCheck:
      return Stage::kCheck;
    case Phase::kIdle:
    case Phase::kDone:
      break;
  }
  return Stage::kRequest;
}

void Plan::enter(Phase phase) noexcept {
  Layout& memory = *memory_;
  const Fences* const fences = has_fences_ ? &memory.fences : nullptr;
  phase_ = phase;
  for (int s = 0; s < kStageCount; ++s) before_[s] = report_.stages[s].work;
  switch (phase) {
    case Phase::kPath: {
      const PathQuery query{memory.ends.start_in_grid,
                            memory.ends.goal_in_grid,
                            asked_.budget.expansions - before(Stage::kSearch),
                            asked_.budget.sight_lines - before(Stage::kShortcut),
                            fences,
                            !at_rest(memory.ends.start),
                            !at_rest(memory.ends.goal),
                            asked_.search};
      return path_begin(memory.stage.path, memory.scans, world(), query);
    }
    case Phase::kCorridor:
      return corridor_begin(memory.stage.corridor, world(), memory.path,
                            asked_.budget.planes - before(Stage::kCorridor), fences);
    case Phase::kPrevious:
      return begin_previous();
    case Phase::kEscape:
      return begin_escape();
    case Phase::kCheck:
      return check_begin(memory.stage.check);
    case Phase::kTimes:
      return begin_times();
    case Phase::kTrajectory:
      return begin_trajectory();
    case Phase::kFences:
    case Phase::kDetour:
    case Phase::kIdle:
    case Phase::kDone:
      break;
  }
}

Status Plan::run_phase(Work& work) noexcept {
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
      status = run_times(work);
      break;
    case Phase::kTrajectory:
      status = run_trajectory(work);
      break;
    case Phase::kDetour:
      status = run_detour(work);
      break;
    case Phase::kPrevious:
      status = run_previous(work);
      break;
    case Phase::kEscape:
      status = run_escape(work);
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

}  // namespace tern
