// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/ledger.hpp"

#include "planner/around.hpp"
#include "planner/previous.hpp"
#include "planner/stop_first.hpp"
#include "planner/timed_seed.hpp"

namespace tern {
namespace {

/// How often a plan may run the steps that its bounds count.
struct Times {
  std::uint32_t goals;     ///< the requested one and, with GoalMode::kNearest, the reachable point instead
  std::uint32_t searches;  ///< of the whole way
  std::uint32_t corridors;
  std::uint32_t seeds;   ///< plans for a corridor: the one as if nothing moved, and the one around things
  std::uint32_t checks;  ///< for each corridor the optimiser's plan, then the fallback; and the remainder
};

Times times_of(const Problem& problem) {
  Times times{};
  times.goals = problem.asked.goal_mode == GoalMode::kNearest ? 2 : 1;
  times.searches = times.goals * (problem.given_at_rest ? 1 : 1 + kStopFirstTries);
  times.corridors = times.goals * (problem.given_at_rest ? 1 : 2 + kStopFirstTries);
  times.checks = times.corridors + times.goals * (problem.asked.previous != nullptr ? 3 : 1);
  times.seeds = problem.thing_count > 0 ? 2 + kTimedSeeds + kMostClosed : 1;
  if (problem.track_count > 0 || problem.has_windows)
    times.checks *= 1 + times.seeds;  // a plan that waits is checked again
  return times;
}

/// How often a stage may run.
std::uint64_t runs_of(Stage stage, const Problem& problem, std::uint32_t remade) {
  const Times times = times_of(problem);
  const std::uint32_t closed = problem.thing_count > 0 ? kMostClosed * times.corridors : 0;
  switch (stage) {
    case Stage::kSearch:
    case Stage::kShortcut:
      return std::uint64_t{times.searches + remade + closed} * static_cast<std::uint64_t>(problem.via_count + 1);
    case Stage::kCorridor:
      return times.corridors + remade + closed + (problem.thing_count > 0 ? kTimedSeeds * times.corridors : 0);
    case Stage::kTimes:
    case Stage::kTrajectory:
      return std::uint64_t{times.seeds} * (times.corridors + times.goals);
    case Stage::kCheck:
    case Stage::kTracks:
      return times.checks;
    case Stage::kWorld:
      return 1 + closed;
    case Stage::kReach:
      return 1;
    case Stage::kRequest:
    case Stage::kDetour:
    case Stage::kPrevious:
    case Stage::kStopFirst:
      break;
  }
  return times.goals;
}

constexpr Operations kNoLimit = Operations{1} << 62;

/// A budget and the stages that share it; kRequest, which is not counted, stands for none.
struct Account {
  std::uint32_t budget;
  Stage stages[3];
};

Account account_of(Stage stage, const Budget& budget) {
  switch (stage) {
    case Stage::kSearch:
    case Stage::kReach:
      return {budget.search, {Stage::kSearch, Stage::kReach, Stage::kRequest}};
    case Stage::kShortcut:
    case Stage::kDetour:
      return {budget.shortcut, {Stage::kShortcut, Stage::kDetour, Stage::kRequest}};
    case Stage::kCorridor:
    case Stage::kPrevious:
    case Stage::kStopFirst:
      return {budget.corridor, {Stage::kCorridor, Stage::kPrevious, Stage::kStopFirst}};
    case Stage::kTrajectory:
      return {budget.trajectory, {Stage::kTrajectory, Stage::kRequest, Stage::kRequest}};
    case Stage::kTracks:
      return {budget.tracks, {Stage::kTracks, Stage::kRequest, Stage::kRequest}};
    case Stage::kRequest:
    case Stage::kWorld:
    case Stage::kTimes:
    case Stage::kCheck:
      break;
  }
  return {kNoBudget, {}};
}

}  // namespace

void Ledger::clear(const Clock& clock) noexcept {
  *this = Ledger{};
  clock_ = clock;
  timed_ = clock.now != nullptr;
}

void Ledger::count(Stage stage, Operations operations, const Problem& problem, std::uint32_t remade) noexcept {
  Operations& spent = spent_[static_cast<int>(stage)];
  spent += operations;
  StageReport& entry = stages_[static_cast<int>(stage)];
  entry.work = static_cast<std::uint64_t>(spent + kUnit - 1) / kUnit;
  if (is_bound_) return;
  is_bound_ = true;
  const StageBound bound = stage_bound(stage, problem.grid->spec());
  entry.bound = bound.units(runs_of(stage, problem, remade));
  if (stage == Stage::kTrajectory) {
    entry.bound += around_bound(problem.thing_count).units(runs_of(stage, problem, remade));
  }
  if (stage == Stage::kCheck) entry.bound += tracks_bound(problem.track_count).units(times_of(problem).checks);
  if (stage == Stage::kTracks) {
    const auto legs = static_cast<std::uint64_t>(problem.via_count) + 1;
    entry.bound += timed_bound(problem.thing_count, problem.grid->spec()).units(legs * times_of(problem).checks);
  }
  if (problem.has_windows && stage == Stage::kCheck) entry.bound += windows_bound().units(times_of(problem).checks);
  if (problem.has_windows && stage == Stage::kTracks) entry.bound += windows_bound().units(kTimedProofs);
  const std::uint32_t budget = account_of(stage, problem.asked.budget).budget;
  const Operations flood = stage == Stage::kTracks ? timed_bound(problem.thing_count, problem.grid->spec()).piece : 0;
  const Operations piece = bound.piece > flood ? bound.piece : flood;
  const std::uint64_t within = budget + static_cast<std::uint64_t>(piece) / kUnit + 1;
  if (budget != kNoBudget && within < entry.bound) entry.bound = within;
}

/// A clock that runs backwards has measured nothing. The plan does not depend on it.
void Ledger::end_slice(Stage stage) noexcept {
  const std::uint64_t now = clock_.ticks();
  stages_[static_cast<int>(stage)].ticks += now - slice_begin_;
  timed_ = timed_ && now >= slice_begin_;
}

Operations Ledger::left(Stage stage, const Budget& budget) const noexcept {
  const Account account = account_of(stage, budget);
  if (account.budget == kNoBudget) return kNoLimit;
  Operations left = kUnit * account.budget;
  for (const Stage of : account.stages) left -= spent(of);
  return left;
}

/// A clock that stood still has measured nothing either. No ticks are better than wrong ones.
void Ledger::write(Diagnostics& diagnostics) const noexcept {
  std::uint64_t sum = 0;
  for (const StageReport& stage : stages_) sum |= stage.ticks;
  diagnostics.timing_known = timed_ && sum != 0;
  for (int s = 0; s < kStageCount; ++s) {
    diagnostics.stages[s] = stages_[s];
    if (!diagnostics.timing_known) diagnostics.stages[s].ticks = 0;
  }
}

}  // namespace tern
