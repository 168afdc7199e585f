// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/path_stage.hpp"

#include "base/direction.hpp"
#include "base/math.hpp"
#include "grid/distance.hpp"

namespace tern {
namespace {

std::int32_t larger_of(std::int32_t a, std::int32_t b) {
  return a < b ? b : a;
}

Status occupied(PathStage& stage, const Grid& grid, const Vec3& point, Status status) {
  stage.raw_occupied = !point_clear(grid, point, 0.0);
  Voxel voxel{};
  stage.has_nearest_free = nearest_free_voxel(grid, point, voxel);
  if (stage.has_nearest_free) stage.nearest_free = grid.center(voxel);
  return status;
}

/// Takes one unit of the search stage from the budget and from the slice. If one of them has none left, returns the
/// status to answer with; otherwise kOk.
Status take_expansion(PathStage& stage, Work& work) {
  if (stage.expansions >= stage.query.max_expansions) return Status::kBudgetSearch;
  if (!work.take()) return Status::kRunning;
  ++stage.expansions;
  return Status::kOk;
}

/// kOk once the end has joined the grid. If no candidate is left: kNoPath after a search that found no way, otherwise
/// kStartOccupied or kGoalOccupied.
Status advance_join(PathStage& stage, const Grid& grid, Work& work, Join& join, const Vec3& point) {
  while (join.state == JoinState::kTrying) {
    const Status taken = take_expansion(stage, work);
    if (taken != Status::kOk) return taken;
    join_try(join, grid, stage.query.fences, point);
  }
  if (join.state == JoinState::kJoined) return Status::kOk;
  if (stage.failed > 0) return Status::kNoPath;
  const bool at_start = &join == &stage.start;
  return occupied(stage, grid, point, at_start ? Status::kStartOccupied : Status::kGoalOccupied);
}

void join_start(PathStage& stage, const Grid& grid) {
  join_begin(stage.start, grid, stage.query.start);
  stage.phase = PathPhase::kJoinStart;
}

/// After a search that found no way, chooses where the next one begins and ends. It tries the other candidates of the
/// start first. Then it tries those of the goal, each with all candidates of the start. kNoPath if none is left.
Status join_elsewhere(PathStage& stage, const Grid& grid) {
  if (++stage.failed == kJoinSearches || stage.expansions >= kExpansionBound) return Status::kNoPath;
  if (join_others(stage.start, grid, stage.query.start, stage.query.start_moves)) {
    stage.phase = PathPhase::kJoinStart;
    return Status::kOk;
  }
  if (!join_others(stage.goal, grid, stage.query.goal, stage.query.goal_moves)) return Status::kNoPath;
  join_start(stage, grid);
  return Status::kOk;
}

/// A path that needs no search: the points coincide, or lie in the same free voxel.
void direct_path(PathStage& stage, Path& out) {
  out.raw_count = 2;
  out.raw[0] = stage.query.start;
  out.raw[1] = stage.query.goal;
  out.grid_length = 0.0;
  stage.search_bound = 1.0;
}

bool is_direct(const PathStage& stage, const Grid& grid) {
  const PathQuery& query = stage.query;
  const Voxel a = grid.voxel_of(query.start);
  const Voxel b = grid.voxel_of(query.goal);
  if (same(a, b) && grid.free(a)) return true;
  return same(query.start, query.goal) && point_clear(grid, query.start, grid.spec().radius);
}

void begin_shortcut(PathStage& stage, const Grid& grid, Path& out) {
  stage.phase = PathPhase::kShortcut;
  stage.stage = Stage::kShortcut;
  shortcut_begin(stage.shortcut, grid, out);
}

/// Writes the whole raw path: exact start, voxel centres, exact goal. A centre that equals the exact start or goal is
/// left out.
Status write_raw(PathStage& stage, const Grid& grid, Path& out) {
  const PathQuery& query = stage.query;
  out.raw_count = 0;
  if (!same(query.start, grid.center(stage.start.voxel))) out.raw[out.raw_count++] = query.start;
  const bool at_center = same(query.goal, grid.center(stage.goal.voxel));
  const Status status = voxel_search_extract(stage.search, grid, at_center ? 0 : 1, out);
  if (status == Status::kOk && !at_center) out.raw[out.raw_count++] = query.goal;
  stage.raw_high = status == Status::kOk ? out.raw_count : kMaxJumpPoints;
  return status;
}

/// A slice of the search, within the stage's budget.
Status run_search(PathStage& stage, const Grid& grid, Work& work) {
  const std::uint32_t most = least(work.left, stage.query.max_expansions - stage.expansions);
  Work allowed{most};
  const Status status = voxel_search_advance(stage.search, grid, allowed);
  work.left -= most - allowed.left;
  stage.expansions += most - allowed.left;
  stage.nodes_high = larger_of(stage.nodes_high, stage.search.nodes_high);
  stage.open_high = larger_of(stage.open_high, stage.search.open_high);
  const bool spent = stage.expansions >= stage.query.max_expansions;
  return status == Status::kRunning && spent ? Status::kBudgetSearch : status;
}

/// kRunning with work left where the path has too many turns and another search may find one with fewer.
Status advance_search(PathStage& stage, const Grid& grid, Work& work, Path& out) {
  Status status = run_search(stage, grid, work);
  if (status != Status::kOk) return status;
  status = write_raw(stage, grid, out);
  if (status == Status::kJumpPointsFull && voxel_search_again(stage.search, grid)) return Status::kRunning;
  if (status != Status::kOk) return status;
  stage.search_used = search_used(stage.search);
  stage.search_bound = search_bound(stage.search, out.grid_length);
  begin_shortcut(stage, grid, out);
  return status;
}

/// Takes one unit of the shortcut stage from the budget and from the slice. If one of them has none left, returns the
/// status to answer with; otherwise kOk.
Status take_sight_line(PathStage& stage, Work& work) {
  if (stage.sight_lines >= stage.query.max_sight_lines) return Status::kBudgetShortcut;
  if (!work.take()) return Status::kRunning;
  ++stage.sight_lines;
  return Status::kOk;
}

/// kOk once the chain is complete and written to `out`; tightening comes next.
Status advance_shortcut(PathStage& stage, const Grid& grid, Work& work, Path& out) {
  while (shortcut_needs_step(stage.shortcut, out)) {
    const Status taken = take_sight_line(stage, work);
    if (taken != Status::kOk) return taken;
    shortcut_step(stage.shortcut, grid, out);
  }
  const Status status = shortcut_finish(stage.shortcut, out);
  stage.segments_high = status == Status::kOk ? out.count - 1 : kMaxSegments;
  if (status != Status::kOk) return status;
  stage.phase = PathPhase::kTighten;
  tighten_begin(stage.tighten, grid, out);
  return status;
}

Status advance_tighten(PathStage& stage, const Grid& grid, Work& work, Path& out) {
  while (tighten_needs_trial(stage.tighten, out)) {
    const Status taken = take_sight_line(stage, work);
    if (taken != Status::kOk) return taken;
    tighten_try(stage.tighten, grid, out);
  }
  return Status::kOk;
}

/// Joins both ends to the grid and searches. If there is no way, repeats this from other voxels that the ends can join.
/// kOk once the raw path is found.
Status find_raw_path(PathStage& stage, const Grid& grid, Work& work, Path& out) {
  for (std::uint32_t k = 0; k <= kJoinSearches; ++k) {
    Status status = Status::kOk;
    if (stage.phase == PathPhase::kJoinStart) {
      status = advance_join(stage, grid, work, stage.start, stage.query.start);
      if (status == Status::kOk) stage.phase = PathPhase::kJoinGoal;
    }
    if (stage.phase == PathPhase::kJoinGoal) {
      status = advance_join(stage, grid, work, stage.goal, stage.query.goal);
      if (status == Status::kOk) {
        voxel_search_begin(stage.search, *stage.map, grid, stage.start.voxel, stage.goal.voxel, stage.query.search);
        stage.phase = PathPhase::kSearch;
      }
    }
    if (stage.phase == PathPhase::kSearch) status = advance_search(stage, grid, work, out);
    if (status != Status::kNoPath || join_elsewhere(stage, grid) != Status::kOk) return status;
  }
  return Status::kNoPath;
}

}  // namespace

void path_begin(PathStage& stage, ScanMap& map, const Grid& grid, const PathQuery& query) noexcept {
  stage.map = &map;
  stage.expansions = 0;
  stage.sight_lines = 0;
  stage.nodes_high = 0;
  stage.open_high = 0;
  stage.raw_high = 0;
  stage.segments_high = 0;
  stage.raw_occupied = false;
  stage.has_nearest_free = false;
  stage.nearest_free = {0.0, 0.0, 0.0};
  stage.stage = Stage::kSearch;
  stage.search_used = SearchUsed::kNone;
  stage.search_bound = 0.0;
  stage.failed = 0;
  stage.query = query;
  join_start(stage, grid);
  join_begin(stage.goal, grid, query.goal);
}

Status path_advance(PathStage& stage, const Grid& grid, Work& work, Path& out) noexcept {
  if (stage.phase == PathPhase::kJoinStart && stage.failed == 0 && is_direct(stage, grid)) {
    direct_path(stage, out);
    begin_shortcut(stage, grid, out);
  } else if (stage.stage == Stage::kSearch) {
    const Status status = find_raw_path(stage, grid, work, out);
    // The shortcut begins with the next call, so that a caller can time search and shortcut separately.
    return status == Status::kOk ? Status::kRunning : status;
  }
  if (stage.phase == PathPhase::kShortcut) {
    const Status status = advance_shortcut(stage, grid, work, out);
    if (status != Status::kOk || stage.phase == PathPhase::kShortcut) return status;
  }
  return advance_tighten(stage, grid, work, out);
}

}  // namespace tern
