// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/problem.hpp"

#include "base/math.hpp"
#include "curve/rest.hpp"
#include "grid/bit_rows.hpp"
#include "planner/validate.hpp"
#include "world/fences.hpp"

namespace tern {
namespace {

/// Operations for each fence that is read: it may have a corner for each triple of faces.
constexpr Operations kFenceOperations = 200 * ops::kPiece;

/// Compares start and vias with walls and solids.
RequestFault find_broken_point(const Problem& problem, const Ends& ends) {
  const World world = world_of(problem);
  const std::int32_t at_start = world.first_broken(ends.start_in_grid, ends.start_in_grid);
  if (at_start != kNoSolid) return {Status::kStartFenced, Field::kStartPosition, at_start};
  for (std::int32_t v = 0; v < problem.via_count; ++v) {
    const Vec3 via = to_local(*problem.grid, problem.vias[v].position);
    const std::int32_t at_via = world.first_broken(via, via);
    if (at_via != kNoSolid) return {Status::kViaFenced, Field::kVias, at_via, v};
  }
  return {Status::kOk, Field::kNone};
}

}  // namespace

State asked_end(const Problem& problem, int end) noexcept {
  const Request& asked = problem.asked;
  State state = end == 0 ? asked.start : asked.goal;
  state.position = end == 0 ? kZero : asked.goal.position - asked.start.position;
  return state;
}

void take_ends(const Problem& problem, Ends& ends) noexcept {
  const Request& asked = problem.asked;
  ends.start = asked_end(problem, 0);
  ends.goal = asked_end(problem, 1);
  ends.start_in_grid = to_local(voxels_of(problem), asked.start.position);
  ends.goal_in_grid = to_local(voxels_of(problem), asked.goal.position);
  ends.origin_in_grid = ends.start_in_grid;
}

Things things_of(const Problem& problem, const Vec3& origin) noexcept {
  return {problem.tracks, problem.thing_count, problem.grid->spec().clearance(), origin, problem.asked.begin,
          problem.solids, problem.track_count};
}

RequestFault read_world(const Request& request, const Ends& ends, Problem& problem, WorldMemory& world,
                        AskedWorld& asked, Operations& spent) noexcept {
  if (request.fence_count == 0) return {Status::kOk, Field::kNone};
  const FenceFault added = world_add(world, request.fences, request.fence_count);
  if (added.status != Status::kOk) return {added.status, Field::kFences, added.fence};
  if (!copy_asked(request.fences, request.fence_count, asked)) return {Status::kFencePlanesFull, Field::kFences};
  problem.asked_world = &asked;
  for (std::int32_t k = 0; k < asked.count; ++k) problem.has_windows = problem.has_windows || is_timed(asked.fence[k]);
  const Verdict clock = problem.has_windows ? validate_clock(request) : Verdict{Status::kOk, Field::kNone};
  if (clock.status != Status::kOk) return {clock.status, clock.field};
  RequestFault fault = find_broken_point(problem, ends);
  if (fault.status != Status::kOk) return fault;
  fault.fence = world_of(problem).first_broken(ends.goal_in_grid, ends.goal_in_grid);
  const bool is_fenced = fault.fence != kNoSolid;
  if (is_fenced) problem.goal_fault = Status::kGoalFenced;
  const bool lacks_goal = is_fenced && request.goal_mode == GoalMode::kExact;
  if (lacks_goal) fault.field = Field::kGoalPosition;
  spent += kFenceOperations * request.fence_count +
           ops::kElement * static_cast<Operations>(GridAccess::layer_words(*problem.grid));
  const Status prepared = world_prepare(world);
  if (prepared == Status::kOk) return fault;
  if (lacks_goal) return {Status::kGoalFenced, Field::kGoalPosition, fault.fence};
  return {prepared, Field::kFences, fault.fence};
}

bool rests(const Problem& problem) noexcept {
  return at_rest(problem.asked.start) && at_rest(problem.asked.goal);
}

bool has_dwells(const Problem& problem) noexcept {
  for (std::int32_t v = 0; v < problem.via_count; ++v) {
    if (problem.vias[v].dwell > 0.0) return true;
  }
  return false;
}

}  // namespace tern
