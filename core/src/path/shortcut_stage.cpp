// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/shortcut_stage.hpp"

#include "base/capacity.hpp"
#include "path/sight.hpp"

namespace tern {
namespace {

/// Instructions of ranking the candidates.
constexpr std::uint32_t kRankEffort = 800;

std::uint32_t chain_effort(const Shortcut& shortcut, const Grid& grid, const Path& path) {
  if (shortcut.probe < 0) return kRankEffort;
  return kRankEffort + sight_effort(grid, path.raw[shortcut.probe], path.raw[shortcut.head]);
}

/// Instructions of a trial: of the lines of sight of both legs at the waypoint. Counted from the waypoint's present
/// place, wherever the trial moves it.
std::uint32_t trial_effort(const Tighten& tighten, const Grid& grid, const Path& path) {
  const Vec3* const at = path.points + tighten.waypoint;
  return kRankEffort + sight_effort(grid, at[-1], at[0]) + sight_effort(grid, at[0], at[1]);
}

/// Takes one unit of work from the budget and from the slice. kDone if both had one left.
Progress take_sight_line(ShortcutStage& stage, Work& work) {
  if (is_full(stage.sight_lines >= stage.max_sight_lines)) return conclude(Status::kBudgetShortcut, stage.status);
  if (!work.take()) return Progress::kMore;
  ++stage.sight_lines;
  return Progress::kDone;
}

/// kDone once the chain is complete and written to the path.
Progress advance_chain(ShortcutStage& stage, const Grid& grid, Work& work, Path& path) {
  while (shortcut_needs_step(stage.shortcut, path)) {
    const Progress taken = take_sight_line(stage, work);
    if (taken != Progress::kDone) return taken;
    work.effort += chain_effort(stage.shortcut, grid, path);
    shortcut_step(stage.shortcut, grid, path);
  }
  const Status status = shortcut_finish(stage.shortcut, path);
  stage.segments_high = status == Status::kOk ? path.count - 1 : kMaxSegments;
  return conclude(status, stage.status);
}

Progress advance_tighten(ShortcutStage& stage, const Grid& grid, Work& work, Path& path) {
  while (tighten_needs_trial(stage.tighten, path)) {
    const Progress taken = take_sight_line(stage, work);
    if (taken != Progress::kDone) return taken;
    work.effort += trial_effort(stage.tighten, grid, path);
    tighten_try(stage.tighten, grid, path);
  }
  return Progress::kDone;
}

}  // namespace

void shortcut_begin(ShortcutStage& stage, const Grid& grid, std::uint32_t max_sight_lines, Path& path) noexcept {
  stage.status = Status::kOk;
  stage.sight_lines = 0;
  stage.segments_high = 0;
  stage.max_sight_lines = max_sight_lines;
  stage.phase = ShortcutPhase::kChain;
  shortcut_begin(stage.shortcut, grid, path);
}

Progress shortcut_advance(ShortcutStage& stage, const Grid& grid, Work& work, Path& path) noexcept {
  if (stage.phase == ShortcutPhase::kChain) {
    const Progress chain = advance_chain(stage, grid, work, path);
    if (chain != Progress::kDone) return chain;
    stage.phase = ShortcutPhase::kTighten;
    tighten_begin(stage.tighten, grid, path);
  }
  return advance_tighten(stage, grid, work, path);
}

}  // namespace tern
