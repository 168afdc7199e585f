// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/legs.hpp"

#include "base/math.hpp"
#include "base/too_narrow.hpp"
#include "curve/rest.hpp"
#include "grid/lattice.hpp"
#include "path/polyline.hpp"
#include "planner/validate.hpp"

namespace tern {
namespace {

Path& path_of_leg(const Problem& problem, WayMemory& way) {
  return problem.via_count > 0 ? way.leg : way.path;
}

Vec3 leg_begin(const Problem& problem, const Ends& ends, const Legs& legs) {
  return legs.leg == 0 ? ends.start_in_grid : to_local(voxels_of(problem), problem.vias[legs.leg - 1].position);
}

/// The via of this index; kNoVia, which is -1, for the start and for the goal.
std::int32_t via_at(const Problem& problem, std::int32_t index) {
  return index < problem.via_count ? index : kNoVia;
}

bool lacks_start_voxel(Status status) {
  return status == Status::kStartOccupied || status == Status::kStartTooNarrow;
}

/// The search's status as that of the plan: an end of the leg that is a via is neither start nor goal.
Status status_of_leg(const Problem& problem, const Legs& legs, Status status) {
  const bool at_via =
      (lacks_start_voxel(status) && legs.leg > 0) || (lacks_goal_voxel(status) && !is_last_leg(problem, legs));
  if (!at_via) return status;
  return is_too_narrow(status) ? Status::kViaTooNarrow : Status::kViaOccupied;
}

/// Why an end joins no voxel. If the end has room: the resolution at which it would have a free voxel, and the wall or
/// solid that blocks its own voxel if obstacles and boundary leave that free.
EndFault fault_of(const Problem& problem, const SearchStage& stage) {
  EndFault fault{stage.raw_occupied, stage.has_nearest_free, kZero, 0.0, kNoSolid};
  if (stage.has_nearest_free) fault.nearest_free = stage.nearest_free + voxels_of(problem).spec().origin;
  if (!is_too_narrow(stage.status)) return fault;
  fault.finer_cell = stage.finer.cell;
  const Voxel home = voxels_of(problem).voxel_of(stage.finer.point);
  if (problem.grid->free(home)) fault.solid = world_of(problem).first_over(cube_of(*problem.grid, home));
  return fault;
}

void note_failure(const Problem& problem, const SearchStage& stage, Legs& legs) {
  legs.status = status_of_leg(problem, legs, stage.status);
  legs.via = via_at(problem, lacks_start_voxel(stage.status) ? legs.leg - 1 : legs.leg);
  legs.fault = fault_of(problem, stage);
}

/// Appends the leg that is finished to the path.
Status join_leg(const Problem& problem, Legs& legs, WayMemory& way) {
  if (problem.via_count == 0) return Status::kOk;
  const Status status = append_to_way(way.leg, way.path);
  if (status == Status::kJumpPointsFull) raise(legs.jump_points_high, kMaxJumpPoints);
  if (status == Status::kSegmentsFull) raise(legs.segments_high, kMaxSegments);
  if (status != Status::kOk) return status;
  raise(legs.jump_points_high, way.path.raw_count);
  raise(legs.segments_high, way.path.count - 1);
  if (!is_last_leg(problem, legs)) way.marks.waypoint[legs.leg] = way.path.count - 1;
  return Status::kOk;
}

}  // namespace

void legs_begin(const Problem& problem, Legs& legs, Path& path) noexcept {
  legs.leg = 0;
  if (problem.via_count > 0) clear_way(path);
}

bool is_last_leg(const Problem& problem, const Legs& legs) noexcept {
  return legs.leg == problem.via_count;
}

Vec3 leg_target(const Problem& problem, const Legs& legs) noexcept {
  const Vec3& target = is_last_leg(problem, legs) ? problem.asked.goal.position : problem.vias[legs.leg].position;
  return to_local(voxels_of(problem), target);
}

Operations leg_search_begin(const Problem& problem, const Ends& ends, const Legs& legs, SearchStage& stage) noexcept {
  const SearchQuery query{leg_begin(problem, ends, legs),
                          is_last_leg(problem, legs) ? ends.goal_in_grid : leg_target(problem, legs),
                          legs.leg == 0 && !at_rest(ends.start), is_last_leg(problem, legs) && !at_rest(ends.goal),
                          legs.choice == WayChoice::kAsked ? problem.asked.search : SearchMode::kOptimal};
  search_begin(stage, world_of(problem), query);
  return join_operations(stage.start) + join_operations(stage.goal);
}

Progress leg_search_advance(const Problem& problem, SearchStage& stage, Legs& legs, WayMemory way,
                            Work& work) noexcept {
  const Progress progress = search_advance(stage, world_of(problem), work, path_of_leg(problem, way));
  raise(legs.nodes_high, stage.nodes_high);
  raise(legs.open_high, stage.open_high);
  raise(legs.jump_points_high, stage.raw_high);
  if (legs.leg == 0 || stage.search_used == SearchUsed::kGuided) legs.search_used = stage.search_used;
  legs.search_bound = legs.leg == 0 ? stage.search_bound : larger(legs.search_bound, stage.search_bound);
  if (progress == Progress::kFailed) note_failure(problem, stage, legs);
  return progress;
}

/// A search that has already failed only looks for a free voxel to report.
void leg_search_stop(const Problem& problem, SearchStage& stage, Legs& legs) noexcept {
  if (stage.phase < SearchPhase::kFiner) stage.status = Status::kBudgetSearch;
  note_failure(problem, stage, legs);
}

void leg_shortcut_begin(const Problem& problem, const Legs& legs, WayMemory way, ShortcutStage& stage) noexcept {
  shortcut_begin(stage, voxels_of(problem), path_of_leg(problem, way), legs.choice == WayChoice::kFewLegs);
}

Progress leg_shortcut_advance(const Problem& problem, ShortcutStage& stage, Legs& legs, WayMemory way,
                              Work& work) noexcept {
  const Progress progress = shortcut_advance(stage, voxels_of(problem), work, path_of_leg(problem, way));
  raise(legs.segments_high, stage.segments_high);
  if (progress == Progress::kMore) return progress;
  legs.via = via_at(problem, legs.leg);
  return conclude(progress == Progress::kFailed ? stage.status : join_leg(problem, legs, way), legs.status);
}

bool choose_again(Status why, Legs& legs) noexcept {
  if (why != Status::kSegmentsFull || legs.choice == WayChoice::kFewLegs) return false;
  const bool is_guided = legs.choice == WayChoice::kAsked && legs.search_used == SearchUsed::kGuided;
  legs.choice = is_guided ? WayChoice::kCheapest : WayChoice::kFewLegs;
  return true;
}

}  // namespace tern
