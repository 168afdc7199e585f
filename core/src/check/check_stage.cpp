// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "check/check_stage.hpp"

namespace tern {
namespace {

bool counts_are_sane(const Corridor& corridor, const Trajectory& trajectory) {
  return corridor.count >= 1 && corridor.count <= kMaxSegments && trajectory.count >= 1 &&
         trajectory.count <= kMaxSegments;
}

Status refuse(CheckStage& stage, Finding finding, std::int32_t where) {
  stage.finding = finding;
  stage.where = where;
  return Status::kCheckFailed;
}

}  // namespace

void check_begin(CheckStage& stage) noexcept {
  stage.next = 0;
  stage.units = 0;
  stage.finding = Finding::kNone;
  stage.where = -1;
}

Status check_advance(CheckStage& stage, const Grid& grid, const Corridor& corridor, const Trajectory& trajectory,
                     const CheckQuery& query, Work& work) noexcept {
  if (!counts_are_sane(corridor, trajectory)) return refuse(stage, Finding::kMalformed, -1);
  const std::int32_t polyhedra = corridor.count;
  const std::int32_t total = polyhedra + trajectory.count;
  for (; stage.next < total; ++stage.next, ++stage.units) {
    if (!work.take()) return Status::kRunning;
    if (stage.next < polyhedra) {
      if (!polyhedron_clear(grid, corridor.polyhedra[stage.next])) {
        return refuse(stage, Finding::kObstacle, stage.next);
      }
      if (query.fences != nullptr &&
          !keep_outs_clear(grid, corridor.polyhedra[stage.next], *query.fences, stage.scratch)) {
        return refuse(stage, Finding::kFence, stage.next);
      }
      continue;
    }
    const int index = stage.next - polyhedra;
    const Finding finding = check_segment(grid, corridor, trajectory, index, query);
    if (finding != Finding::kNone) return refuse(stage, finding, index);
    const double tolerance = fence_tolerance(grid) + place_rounding(grid, trajectory);
    if (query.fences != nullptr &&
        !keep_ins_hold(trajectory.segments[index], *query.fences, trajectory.origin, tolerance)) {
      return refuse(stage, Finding::kFence, index);
    }
  }
  return Status::kOk;
}

}  // namespace tern
