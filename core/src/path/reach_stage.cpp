// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/reach_stage.hpp"

#include "base/capacity.hpp"
#include "grid/distance.hpp"

namespace tern {
namespace {

void clear(ReachStage& stage, const Grid& grid) {
  if (!flood_clear(stage.flood)) return;
  const bool any_free = nearest_free_voxel(grid, stage.query.goal, stage.best);
  join_begin(stage.start, grid, stage.query.start);
  stage.phase = any_free ? ReachPhase::kJoin : ReachPhase::kEnd;
}

/// Joins the start to a voxel, and begins to flood from there.
void join(ReachStage& stage, const Grid& grid) {
  if (stage.start.state == JoinState::kTrying) join_try(stage.start, grid, stage.query.fences, stage.query.start);
  if (stage.start.state == JoinState::kRefused) stage.phase = ReachPhase::kEnd;
  if (stage.start.state != JoinState::kJoined) return;
  flood_from(stage.flood, grid, stage.start.voxel);
  stage.joined = true;
  stage.phase = ReachPhase::kFlood;
}

/// A row; after the last one, goes on from the next voxel that the start can join.
void flood(ReachStage& stage, const Grid& grid) {
  if (flooded(stage.flood, grid).free(stage.best)) {
    stage.phase = ReachPhase::kEnd;
  } else if (stage.flood.count > 0) {
    flood_row(stage.flood, grid);
  } else {
    const bool others = join_others(stage.start, grid, stage.query.start, stage.query.start_moves);
    stage.phase = others ? ReachPhase::kJoin : ReachPhase::kEnd;
  }
}

void advance_once(ReachStage& stage, const Grid& grid) {
  switch (stage.phase) {
    case ReachPhase::kClear:
      return clear(stage, grid);
    case ReachPhase::kJoin:
      return join(stage, grid);
    case ReachPhase::kFlood:
      return flood(stage, grid);
    case ReachPhase::kEnd:
      break;
  }
}

}  // namespace

void reach_begin(ReachStage& stage, const Grid& grid, const ReachQuery& query) noexcept {
  const bool fits = !is_full(!flood_begin(stage.flood, grid));
  stage.status = fits ? Status::kOk : Status::kFenceLayerFull;
  stage.units = 0;
  stage.joined = false;
  stage.phase = fits ? ReachPhase::kClear : ReachPhase::kEnd;
  stage.query = query;
}

Progress reach_advance(ReachStage& stage, const Grid& grid, Work& work) noexcept {
  // Each turn takes a unit, and there are at most kReachBound.
  while (stage.phase != ReachPhase::kEnd) {
    if (is_full(stage.units >= stage.query.max_units)) return conclude(Status::kBudgetSearch, stage.status);
    if (!work.take()) return Progress::kMore;
    ++stage.units;
    advance_once(stage, grid);
  }
  if (stage.status != Status::kOk) return Progress::kFailed;
  if (!stage.joined) return conclude(Status::kStartOccupied, stage.status);
  nearest_free_voxel(flooded(stage.flood, grid), stage.query.goal, stage.nearest);
  return Progress::kDone;
}

}  // namespace tern
