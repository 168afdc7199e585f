// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/ledger.hpp"

#include "base/work.hpp"
#include "corridor/corridor_stage.hpp"
#include "path/reach_stage.hpp"
#include "path/search_stage.hpp"
#include "path/shortcut_stage.hpp"
#include "planner/detour.hpp"
#include "planner/previous.hpp"
#include "planner/stop_first.hpp"
#include "prove/check_stage.hpp"
#include "times/times_stage.hpp"
#include "trajectory/trajectory_stage.hpp"

namespace tern {
namespace {

/// How often a plan may do what its bounds count.
struct Times {
  std::uint32_t goals;     ///< the requested one and, with GoalMode::kNearest, the reachable point instead
  std::uint32_t searches;  ///< of the whole way
  std::uint32_t corridors;
  std::uint32_t checks;  ///< for each corridor the optimiser's plan, then the fallback; and the remainder
};

Times times_of(const Problem& problem) {
  Times times{};
  times.goals = problem.asked.goal_mode == GoalMode::kNearest ? 2 : 1;
  times.searches = times.goals * (problem.given_at_rest ? 1 : 1 + kStopFirstTries);
  times.corridors = times.goals * (problem.given_at_rest ? 1 : 2 + kStopFirstTries);
  times.checks = times.corridors + times.goals * (problem.asked.previous != nullptr ? 3 : 1);
  return times;
}

/// The most units of all searches together, if one search takes at most `bound` units a leg.
std::uint32_t legs_searched(const Problem& problem, std::uint32_t searches, std::uint32_t bound) {
  const std::uint64_t all = std::uint64_t{searches} * static_cast<std::uint64_t>(problem.via_count + 1) * bound;
  return all < 0xFFFFFFFFu ? static_cast<std::uint32_t>(all) : 0xFFFFFFFFu;
}

/// The most work of a stage in one plan.
std::uint32_t bound_of(Stage stage, const Problem& problem, std::uint32_t searched_again) {
  const Budget& budget = problem.asked.budget;
  const Times times = times_of(problem);
  switch (stage) {
    case Stage::kFences:
      return kWorldBound;
    case Stage::kSearch:
      return least(budget.expansions, legs_searched(problem, times.searches + searched_again, kSearchBound));
    case Stage::kShortcut:
      return least(budget.sight_lines, legs_searched(problem, times.searches + searched_again, kShortcutBound));
    case Stage::kCorridor:
      return least(budget.planes, (times.corridors + searched_again) * kCorridorBound);
    case Stage::kTimes:
      return (times.corridors + times.goals) * kTimesBound;
    case Stage::kTrajectory:
      return least(budget.iterations, times.corridors * kTrajectoryBound);
    case Stage::kCheck:
      return times.checks * kCheckBound;
    case Stage::kDetour:
      return least(budget.sight_lines, times.goals * kDetourLines);
    case Stage::kPrevious:
      return least(budget.planes, times.goals * kPreviousPlanes);
    case Stage::kEscape:
      return least(budget.planes, times.goals * kStopFirstPlanes);
    case Stage::kReach:
      return least(budget.expansions, kReachBound);
    case Stage::kRequest:
      break;
  }
  return 0;
}

}  // namespace

void Ledger::clear(bool timed) noexcept {
  *this = Ledger{};
  timed_ = timed;
}

void Ledger::count(Stage stage, std::uint32_t units, const Problem& problem, bool searched_again) noexcept {
  StageReport& entry = stages_[static_cast<int>(stage)];
  entry.work = before_ + units;
  entry.bound = bound_of(stage, problem, searched_again ? 1 : 0);
}

/// A clock that runs backwards has measured nothing. The plan does not depend on it.
void Ledger::count_ticks(Stage stage, std::uint64_t begin, std::uint64_t end) noexcept {
  stages_[static_cast<int>(stage)].ticks += end - begin;
  timed_ = timed_ && end >= begin;
}

std::uint32_t Ledger::expansions_left(const Budget& budget) const noexcept {
  return budget.expansions - work(Stage::kSearch) - work(Stage::kReach);
}

std::uint32_t Ledger::sight_lines_left(const Budget& budget) const noexcept {
  return budget.sight_lines - work(Stage::kShortcut) - work(Stage::kDetour);
}

std::uint32_t Ledger::planes_left(const Budget& budget) const noexcept {
  return budget.planes - work(Stage::kCorridor) - work(Stage::kPrevious) - work(Stage::kEscape);
}

std::uint32_t Ledger::iterations_left(const Budget& budget) const noexcept {
  return budget.iterations - work(Stage::kTrajectory);
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
