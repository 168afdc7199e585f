// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/search_stage.hpp"

#include "base/capacity.hpp"
#include "base/direction.hpp"
#include "base/math.hpp"
#include "grid/distance.hpp"
#include "grid/lattice.hpp"

namespace tern {
namespace {

/// Operations of examining both ends, each with the rows around it.
constexpr Operations kEndsOperations = 2 * kJoinWidth * kJoinWidth * ops::kRow;

/// Refuses an end that joins no voxel, and begins to look for the free voxel nearest to it. If the end has room, first
/// looks for a resolution at which it would join.
void refuse_end(SearchStage& stage, const Grid& grid, const Vec3& point, bool at_start) {
  const bool has_room = point_clear(grid, point, grid.spec().clearance());
  const Status narrow = at_start ? Status::kStartTooNarrow : Status::kGoalTooNarrow;
  stage.status = has_room ? narrow : (at_start ? Status::kStartOccupied : Status::kGoalOccupied);
  stage.raw_occupied = !point_clear(grid, point, 0.0);
  stage.phase = has_room ? SearchPhase::kFiner : SearchPhase::kNearest;
  finer_begin(stage.finer, point);
  nearest_begin(stage.nearest, grid, point);
}

Progress advance_nearest(SearchStage& stage, const World& world, Work& work) {
  const Grid& grid = world.voxels();
  if (stage.phase == SearchPhase::kFiner) {
    if (finer_advance(stage.finer, world, work) == Progress::kMore) return Progress::kMore;
    stage.phase = SearchPhase::kNearest;
  }
  if (nearest_advance(stage.nearest, grid, work) == Progress::kMore) return Progress::kMore;
  stage.has_nearest_free = stage.nearest.found;
  if (stage.nearest.found) stage.nearest_free = free_point(grid, stage.nearest.voxel);
  return Progress::kFailed;
}

/// Tries to join an end to the grid. kDone once it has joined. If no candidate is left: kNoPath after a search that
/// found no path, otherwise goes on with refuse_end.
Progress advance_join(SearchStage& stage, const World& world, Work& work, Join& join, const Vec3& point) {
  while (join.state == JoinState::kTrying) {
    if (!work.left()) return Progress::kMore;
    ++stage.pieces;
    join_try(join, world, point, work);
  }
  if (join.state == JoinState::kJoined) return Progress::kDone;
  if (stage.failed > 0) return conclude(Status::kNoPath, stage.status);
  refuse_end(stage, world.voxels(), point, &join == &stage.start);
  return advance_nearest(stage, world, work);
}

void join_start(SearchStage& stage, const World& world) {
  join_begin(stage.start, world, stage.query.start);
  stage.phase = SearchPhase::kJoinStart;
}

/// After a search that found no path, chooses the ends of the next one. First come the other candidates of the start,
/// then those of the goal, each with all candidates of the start. False if none is left.
bool join_elsewhere(SearchStage& stage, const World& world, Work& work) {
  const Grid& grid = world.voxels();
  if (++stage.failed == kJoinSearches || stage.pieces >= kExpansionBound) return false;
  const bool has_other = join_others(stage.start, grid, stage.query.start, stage.query.start_moves);
  work.spend(kSearchedOperations + join_operations(stage.start));
  if (has_other) {
    stage.phase = SearchPhase::kJoinStart;
    return true;
  }
  const bool has_goal = join_others(stage.goal, grid, stage.query.goal, stage.query.goal_moves);
  work.spend(kSearchedOperations + join_operations(stage.goal));
  if (!has_goal) return false;
  join_start(stage, world);
  work.spend(join_operations(stage.start));
  return true;
}

bool is_direct(const SearchStage& stage, const Grid& grid) {
  const SearchQuery& query = stage.query;
  const Voxel a = grid.voxel_of(query.start);
  const Voxel b = grid.voxel_of(query.goal);
  if (same(a, b) && grid.free(a)) return true;
  return same(query.start, query.goal) && point_clear(grid, query.start, grid.spec().clearance());
}

/// Writes a path that needs no search: the points coincide, or lie in the same free voxel.
void direct_path(SearchStage& stage, Path& out) {
  stage.search_bound = 1.0;
  out.raw_count = 2;
  out.raw[0] = stage.query.start;
  out.raw[1] = stage.query.goal;
  out.grid_length = 0.0;
}

/// Writes the whole raw path: exact start, voxel centres, exact goal. A centre that equals the exact start or goal is
/// left out.
Status write_raw(SearchStage& stage, const Grid& grid, Path& out, Work& work) {
  const SearchQuery& query = stage.query;
  out.raw_count = 0;
  if (!same(query.start, free_point(grid, stage.start.voxel))) out.raw[out.raw_count++] = query.start;
  const bool at_center = same(query.goal, free_point(grid, stage.goal.voxel));
  const Status status = voxel_search_extract(stage.search, grid, at_center ? 0 : 1, out);
  if (status == Status::kOk && !at_center) out.raw[out.raw_count++] = query.goal;
  stage.raw_high = status == Status::kOk ? out.raw_count : kMaxJumpPoints;
  const double voxels = status == Status::kOk ? out.grid_length : kMaxJumpPoints;
  work.spend(ops::kPiece + ops::kNode * (static_cast<Operations>(voxels) + stage.raw_high));
  return status;
}

/// Runs a slice of the search.
Status run_search(SearchStage& stage, const Grid& grid, Work& work) {
  const std::uint32_t before = stage.search.entries;
  const Status status = voxel_search_advance(stage.search, grid, work);
  stage.pieces += stage.search.entries - before;
  raise(stage.nodes_high, stage.search.nodes_high);
  raise(stage.open_high, stage.search.open_high);
  return status;
}

/// Runs a slice of the search, and writes the path once it is found. If a path of the fast search has too many turns,
/// searches again for a cheapest path.
Progress expand(SearchStage& stage, const Grid& grid, Work& work, Path& out) {
  Status status = run_search(stage, grid, work);
  if (status == Status::kOk) status = write_raw(stage, grid, out, work);
  if (status == Status::kJumpPointsFull && voxel_search_again(stage.search, grid)) {
    status = run_search(stage, grid, work);
    if (status == Status::kOk) status = write_raw(stage, grid, out, work);
  }
  if (status == Status::kOk) {
    stage.search_used = search_used(stage.search);
    stage.search_bound = search_bound(stage.search, out.grid_length);
  }
  return status == Status::kRunning ? Progress::kMore : conclude(status, stage.status);
}

/// Joins both ends to the grid and searches once, going on from the current phase.
Progress advance_once(SearchStage& stage, const World& world, Work& work, Path& out) {
  const Grid& grid = world.voxels();
  if (stage.phase >= SearchPhase::kFiner) return advance_nearest(stage, world, work);
  if (stage.phase == SearchPhase::kJoinStart) {
    const Progress joined = advance_join(stage, world, work, stage.start, stage.query.start);
    if (joined != Progress::kDone) return joined;
    stage.phase = SearchPhase::kJoinGoal;
  }
  if (stage.phase == SearchPhase::kJoinGoal) {
    const Progress joined = advance_join(stage, world, work, stage.goal, stage.query.goal);
    if (joined != Progress::kDone) return joined;
    work.spend(kEndsOperations);
    voxel_search_begin(stage.search, grid, stage.start.voxel, stage.goal.voxel, stage.query.mode);
    stage.phase = SearchPhase::kSearch;
  }
  return expand(stage, grid, work, out);
}

}  // namespace

void search_begin(SearchStage& stage, const World& world, const SearchQuery& query) noexcept {
  stage.status = Status::kOk;
  stage.pieces = 0;
  stage.nodes_high = 0;
  stage.open_high = 0;
  stage.raw_high = 0;
  stage.search_used = SearchUsed::kNone;
  stage.search_bound = 0.0;
  stage.raw_occupied = false;
  stage.has_nearest_free = false;
  stage.nearest_free = {0.0, 0.0, 0.0};
  stage.failed = 0;
  stage.query = query;
  join_start(stage, world);
  join_begin(stage.goal, world, query.goal);
}

Progress search_advance(SearchStage& stage, const World& world, Work& work, Path& out) noexcept {
  const Grid& grid = world.voxels();
  if (stage.phase == SearchPhase::kJoinStart && stage.failed == 0 && is_direct(stage, grid)) {
    work.spend(kEndsOperations);
    direct_path(stage, out);
    return Progress::kDone;
  }
  // If there is no path, searches again from other voxels that the ends can join.
  for (std::uint32_t k = 0; k <= kJoinSearches; ++k) {
    const Progress progress = advance_once(stage, world, work, out);
    const bool no_path = progress == Progress::kFailed && stage.status == Status::kNoPath;
    if (!no_path || !join_elsewhere(stage, world, work)) return progress;
  }
  return Progress::kFailed;
}

}  // namespace tern
