// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/shortcut_stage.hpp"

#include "path/sight.hpp"

namespace tern {
namespace {

/// A step of the chain ranks the candidates, and looks along at most one line.
Operations chain_operations(const Shortcut& shortcut, const Grid& grid, const Path& path) {
  if (shortcut.probe < 0) return ops::kPiece;
  return ops::kPiece + sight_operations(grid, path.raw[shortcut.probe], path.raw[shortcut.head]);
}

/// A trial looks along both legs at the waypoint. They count as long as they are before the trial moves the waypoint.
Operations trial_operations(const Tighten& tighten, const Grid& grid, const Path& path) {
  const Vec3* const at = path.points + tighten.waypoint;
  return ops::kPiece + sight_operations(grid, at[-1], at[0]) + sight_operations(grid, at[0], at[1]);
}

/// Ends a phase that writes the waypoints.
Progress end_phase(ShortcutStage& stage, Status status, const Path& path) {
  stage.segments_high = status == Status::kOk ? path.count - 1 : kMaxSegments;
  return conclude(status, stage.status);
}

/// kDone once the chain is complete and, unless it is to be merged, written to the path.
Progress advance_chain(ShortcutStage& stage, const Grid& grid, Work& work, Path& path) {
  while (shortcut_needs_step(stage.shortcut, path)) {
    if (!work.left()) return Progress::kMore;
    ++stage.pieces;
    work.spend(chain_operations(stage.shortcut, grid, path));
    shortcut_step(stage.shortcut, grid, path);
  }
  return stage.few_legs ? Progress::kDone : end_phase(stage, shortcut_finish(stage.shortcut, path), path);
}

Progress advance_merge(ShortcutStage& stage, const Grid& grid, Work& work, Path& path) {
  Status status = Status::kRunning;
  while (status == Status::kRunning) {
    if (!work.left()) return Progress::kMore;
    ++stage.pieces;
    work.spend(merge_operations(stage.merge, grid, path));
    status = merge_step(stage.merge, stage.shortcut, grid, path);
  }
  return end_phase(stage, status, path);
}

Progress advance_tighten(ShortcutStage& stage, const Grid& grid, Work& work, Path& path) {
  while (tighten_needs_trial(stage.tighten, path)) {
    if (!work.left()) return Progress::kMore;
    ++stage.pieces;
    work.spend(trial_operations(stage.tighten, grid, path));
    tighten_try(stage.tighten, grid, path);
  }
  return Progress::kDone;
}

}  // namespace

void shortcut_begin(ShortcutStage& stage, const Grid& grid, Path& path, bool few_legs) noexcept {
  stage.status = Status::kOk;
  stage.pieces = 0;
  stage.segments_high = 0;
  stage.few_legs = few_legs;
  stage.phase = ShortcutPhase::kChain;
  shortcut_begin(stage.shortcut, grid, path);
}

Progress shortcut_advance(ShortcutStage& stage, const Grid& grid, Work& work, Path& path) noexcept {
  if (stage.phase == ShortcutPhase::kChain) {
    const Progress chain = advance_chain(stage, grid, work, path);
    if (chain != Progress::kDone) return chain;
    stage.phase = ShortcutPhase::kMerge;
    if (stage.few_legs) merge_begin(stage.merge, stage.shortcut, path);
  }
  if (stage.phase == ShortcutPhase::kMerge) {
    const Progress merged = stage.few_legs ? advance_merge(stage, grid, work, path) : Progress::kDone;
    if (merged != Progress::kDone) return merged;
    stage.phase = ShortcutPhase::kTighten;
    tighten_begin(stage.tighten, grid, path);
  }
  return advance_tighten(stage, grid, work, path);
}

}  // namespace tern
