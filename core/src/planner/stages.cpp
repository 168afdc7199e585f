// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Entering a stage, and running a slice of it.
#include "base/progress.hpp"
#include "base/work.hpp"
#include "curve/rest.hpp"
#include "planner/layout.hpp"
#include "planner/plan.hpp"

namespace tern {

void Plan::enter(Stage stage) noexcept {
  stage_ = stage;
  for (int s = 0; s < kStageCount; ++s) before_[s] = report_.diagnostics.stages[s].work;
  switch (stage) {
    case Stage::kSearch:
      return begin_search();
    case Stage::kShortcut:
      return begin_shortcut();
    case Stage::kCorridor:
      return begin_corridor();
    case Stage::kTimes:
      return begin_times();
    case Stage::kTrajectory:
      return begin_trajectory();
    case Stage::kPrevious:
      return begin_previous();
    case Stage::kEscape:
      return begin_escape();
    case Stage::kReach:
      return begin_reach();
    case Stage::kCheck:
      return check_begin(memory_->stage.check);
    case Stage::kRequest:
    case Stage::kFences:
    case Stage::kDetour:
      break;
  }
}

Progress Plan::run_stage(Work& work) noexcept {
  switch (stage_) {
    case Stage::kFences:
      return run_world(work);
    case Stage::kSearch:
      return run_search(work);
    case Stage::kShortcut:
      return run_shortcut(work);
    case Stage::kCorridor:
      return run_corridor(work);
    case Stage::kTimes:
      return run_times(work);
    case Stage::kTrajectory:
      return run_trajectory(work);
    case Stage::kDetour:
      return run_detour(work);
    case Stage::kPrevious:
      return run_previous(work);
    case Stage::kEscape:
      return run_escape(work);
    case Stage::kReach:
      return run_reach(work);
    case Stage::kCheck:
      return run_check(work);
    case Stage::kRequest:
      break;
  }
  return Progress::kDone;
}

/// Runs a slice of the current stage, and times it for the report.
Progress Plan::advance(Work& work) noexcept {
  StageReport& entry = report_.diagnostics.stages[static_cast<int>(stage_)];
  const std::uint64_t before = clock_ != nullptr ? clock_(clock_context_) : 0;
  const Progress progress = run_stage(work);
  const std::uint64_t after = clock_ != nullptr ? clock_(clock_context_) : 0;
  // A clock that runs backwards has measured nothing. The plan does not depend on it.
  if (after < before) report_.diagnostics.timing_known = false;
  entry.ticks += after - before;
  return progress;
}

}  // namespace tern
