// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/reach_stage.hpp"

#include "base/capacity.hpp"
#include "grid/distance.hpp"

namespace tern {
namespace {

void clear(ReachStage& stage, const Grid& grid, Work& work) {
  work.spend(static_cast<Operations>(kClearedWords));
  if (!flood_clear(stage.flood)) return;
  nearest_begin(stage.search, grid, stage.query.goal);
  stage.phase = ReachPhase::kBest;
}

/// Takes the result of the search for the nearest free voxel, or for the nearest voxel that was reached.
void take_nearest(ReachStage& stage, const World& world, Work& work) {
  const bool found = stage.search.found;
  if (stage.phase == ReachPhase::kNearest) {
    if (found) stage.nearest = stage.search.voxel;
    stage.phase = ReachPhase::kEnd;
    return;
  }
  if (found) stage.best = stage.search.voxel;
  join_begin(stage.start, world, stage.query.start);
  work.spend(join_operations(stage.start));
  stage.phase = found ? ReachPhase::kJoin : ReachPhase::kEnd;
}

/// Ends the flood, and begins to look for the nearest voxel that it has reached, if there is any.
void end_flood(ReachStage& stage, const Grid& grid) {
  stage.phase = stage.joined ? ReachPhase::kNearest : ReachPhase::kEnd;
  if (stage.joined) nearest_begin(stage.search, flooded(stage.flood, grid), stage.query.goal);
}

/// Joins the start to a voxel, and begins to flood from there.
void join(ReachStage& stage, const World& world, Work& work) {
  const Grid& grid = world.voxels();
  if (stage.start.state == JoinState::kTrying) join_try(stage.start, world, stage.query.start, work);
  if (stage.start.state == JoinState::kRefused) end_flood(stage, grid);
  if (stage.start.state != JoinState::kJoined) return;
  flood_from(stage.flood, grid, stage.start.voxel);
  stage.joined = true;
  stage.phase = ReachPhase::kFlood;
}

/// Floods one row. After the last row, goes on from the next voxel that the start can join.
void flood(ReachStage& stage, const Grid& grid, Work& work) {
  if (flooded(stage.flood, grid).free(stage.best)) {
    end_flood(stage, grid);
  } else if (stage.flood.count > 0) {
    work.spend(9 * ops::kWord * grid.row_words());
    flood_row(stage.flood, grid);
  } else {
    const bool others = join_others(stage.start, grid, stage.query.start, stage.query.start_moves);
    work.spend(kSearchedOperations + join_operations(stage.start));
    others ? static_cast<void>(stage.phase = ReachPhase::kJoin) : end_flood(stage, grid);
  }
}

void advance_once(ReachStage& stage, const World& world, Work& work) {
  const Grid& grid = world.voxels();
  work.spend(4 * ops::kPiece);
  if (stage.phase == ReachPhase::kClear) return clear(stage, grid, work);
  stage.phase == ReachPhase::kJoin ? join(stage, world, work) : flood(stage, grid, work);
}

bool searches(const ReachStage& stage) {
  return stage.phase == ReachPhase::kBest || stage.phase == ReachPhase::kNearest;
}

}  // namespace

void reach_begin(ReachStage& stage, const World& world, const ReachQuery& query) noexcept {
  const bool fits = !is_full(!flood_begin(stage.flood, world.voxels()));
  stage.status = fits ? Status::kOk : Status::kWorldFull;
  stage.joined = false;
  stage.phase = fits ? ReachPhase::kClear : ReachPhase::kEnd;
  stage.query = query;
}

Progress reach_advance(ReachStage& stage, const World& world, Work& work) noexcept {
  const Grid& grid = world.voxels();
  // Each turn is a piece of work or ends a search. At most kReachBound turns are pieces of anything but a search.
  while (stage.phase != ReachPhase::kEnd) {
    if (searches(stage)) {
      const Grid reached = stage.phase == ReachPhase::kNearest ? flooded(stage.flood, grid) : grid;
      if (nearest_advance(stage.search, reached, work) == Progress::kMore) return Progress::kMore;
      take_nearest(stage, world, work);
      continue;
    }
    if (!work.left()) return Progress::kMore;
    advance_once(stage, world, work);
  }
  if (stage.status != Status::kOk) return Progress::kFailed;
  return stage.joined ? Progress::kDone : conclude(Status::kStartOccupied, stage.status);
}

}  // namespace tern
