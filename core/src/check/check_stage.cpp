// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "check/check_stage.hpp"

namespace tern {
namespace {

bool counts_are_sane(const Corridor& corridor, const Trajectory& trajectory) {
  return corridor.count >= 1 && corridor.count <= kMaxSegments && trajectory.count >= 1 &&
         trajectory.count <= kMaxSegments;
}

/// Instructions of a segment, of each half-space of its polyhedron, and of a fence.
constexpr std::uint32_t kSegmentEffort = 6000;
constexpr std::uint32_t kPlaneEffort = 150;
constexpr std::uint32_t kFenceEffort = 30000;

bool check_polyhedron(CheckStage& stage, const Grid& grid, const Polyhedron& polyhedron, const CheckQuery& query,
                      Work& work) {
  if (query.fences != nullptr) work.effort += effort_of(kFenceEffort, query.fences->count);
  const bool clear =
      polyhedron_clear(grid, polyhedron, stage, &work.effort) &&
      (query.fences == nullptr || keep_outs_clear(grid, polyhedron, *query.fences, stage.scratch, stage));
  if (!clear) stage.polyhedron = stage.next;
  return clear;
}

/// Half-spaces that the segment is checked against; 0 if it names no polyhedron.
int planes_of(const Corridor& corridor, const Segment& segment) {
  if (segment.polyhedron < 0 || segment.polyhedron >= corridor.count) return 0;
  const int planes = all_planes(corridor.polyhedra[segment.polyhedron]);
  return planes < 0 ? 0 : (planes < kMaxPlanes ? planes : kMaxPlanes);
}

bool check_segment(CheckStage& stage, const Grid& grid, const Corridor& corridor, const Trajectory& trajectory,
                   const CheckQuery& query, Work& work) {
  const int index = stage.next - corridor.count;
  work.effort += kSegmentEffort + effort_of(kPlaneEffort, planes_of(corridor, trajectory.segments[index]));
  const double tolerance = fence_tolerance(grid) + place_rounding(grid, trajectory);
  const bool holds = segment_holds(grid, corridor, trajectory, index, query, stage) &&
                     (query.fences == nullptr ||
                      keep_ins_hold(trajectory.segments[index], *query.fences, trajectory.origin, tolerance, stage));
  if (!holds) stage.segment = index;
  if (!holds || index + 1 < trajectory.count) return holds;
  return vias_met(grid, trajectory, query, stage);
}

}  // namespace

void check_begin(CheckStage& stage) noexcept {
  stage.status = Status::kOk;
  stage.next = 0;
  stage.units = 0;
  static_cast<CheckReport&>(stage) = CheckReport{};
}

Progress check_advance(CheckStage& stage, const Grid& grid, const Corridor& corridor, const Trajectory& trajectory,
                       const CheckQuery& query, Work& work) noexcept {
  if (!counts_are_sane(corridor, trajectory)) {
    refuse(Finding::kMalformed, stage);
    return conclude(Status::kCheckFailed, stage.status);
  }
  const std::int32_t total = corridor.count + trajectory.count;
  for (; stage.next < total; ++stage.next, ++stage.units) {
    if (!work.take()) return Progress::kMore;
    const bool holds = stage.next < corridor.count
                           ? check_polyhedron(stage, grid, corridor.polyhedra[stage.next], query, work)
                           : check_segment(stage, grid, corridor, trajectory, query, work);
    if (!holds) return conclude(Status::kCheckFailed, stage.status);
  }
  return Progress::kDone;
}

}  // namespace tern
