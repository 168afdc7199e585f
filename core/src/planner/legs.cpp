// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The way through the vias. Each leg, from a via to the next, is searched for and shortened by itself. The whole way
// then gets one corridor, one chain and one trajectory.
#include "base/capacity.hpp"
#include "base/math.hpp"
#include "base/too_narrow.hpp"
#include "grid/lattice.hpp"
#include "path/way.hpp"
#include "planner/layout.hpp"
#include "planner/plan.hpp"
#include "planner/validate.hpp"

namespace tern {
namespace {

/// Half the edge of the cube that fits into the ball of a via's tolerance, less a reserve: the solver may leave the
/// cube by a nanometre.
double reach_of(const Via& via) {
  constexpr double kRootThree = 1.7320508075688774;
  constexpr double kSolverReserve = 2e-9;
  return via.tolerance < kLeastTolerance ? 0.0 : via.tolerance / kRootThree - kSolverReserve;
}

Hold hold_of(const Via& via, const Vec3& origin, std::int32_t polyhedron, double reach) {
  return Hold{polyhedron, 0, via.position - origin, reach, via.stop, via.has_velocity, via.velocity};
}

/// Inserts a segment that rests at the joint for `duration`: all its control points are the same.
void insert_rest(Trajectory& trajectory, int joint, double duration) {
  for (int s = trajectory.count; s > joint; --s) trajectory.segments[s] = trajectory.segments[s - 1];
  const bool at_end = joint == trajectory.count;
  const Segment& beside = at_end ? trajectory.segments[joint - 1] : trajectory.segments[joint];
  const Vec3 place = beside.points[at_end ? kDegree : 0];
  Segment& rest = trajectory.segments[joint];
  rest.polyhedron = beside.polyhedron;
  rest.duration = duration;
  for (Vec3& point : rest.points) point = place;
  ++trajectory.count;
}

}  // namespace

std::int32_t Plan::via_count() const noexcept {
  return memory_->mission.marks.count;
}

/// Begins the search for the first leg.
void Plan::begin_way() noexcept {
  leg_ = 0;
  has_path_ = false;
  if (via_count() > 0) clear_way(memory_->path);
  enter(Stage::kSearch);
}

/// Both ends of the current leg, local frame.
Vec3 Plan::leg_from() const noexcept {
  return leg_ == 0 ? memory_->ends.start_in_grid : to_local(voxels(), memory_->mission.vias[leg_ - 1].position);
}

Vec3 Plan::leg_to() const noexcept {
  return leg_ == via_count() ? memory_->ends.goal_in_grid : to_local(voxels(), memory_->mission.vias[leg_].position);
}

/// Without vias, the path's only leg is the path.
Path& Plan::leg_path() noexcept {
  return via_count() > 0 ? memory_->mission.leg : memory_->path;
}

/// Appends the leg that is finished to the path.
Status Plan::join_leg() noexcept {
  if (via_count() == 0) return Status::kOk;
  Layout& memory = *memory_;
  const Status status = append_to_way(memory.mission.leg, memory.path);
  if (status == Status::kJumpPointsFull) raise(report_.diagnostics.high_water.jump_points, kMaxJumpPoints);
  if (status == Status::kSegmentsFull) raise(report_.diagnostics.high_water.segments, kMaxSegments);
  if (status != Status::kOk) return status;
  raise(report_.diagnostics.high_water.jump_points, memory.path.raw_count);
  raise(report_.diagnostics.high_water.segments, memory.path.count - 1);
  if (leg_ < via_count()) memory.mission.marks.waypoint[leg_] = memory.path.count - 1;
  return Status::kOk;
}

/// The status of the current leg as that of the plan: an end of the leg that is a via is neither start nor goal.
Status Plan::status_of_leg(Status status) const noexcept {
  const bool at_start = status == Status::kStartOccupied || status == Status::kStartTooNarrow;
  const bool at_via = (at_start && leg_ > 0) || (lacks_goal_voxel(status) && leg_ < via_count());
  if (!at_via) return status;
  return is_too_narrow(status) ? Status::kViaTooNarrow : Status::kViaOccupied;
}

/// If the first search failed because an end has room but no free voxel, notes the resolution at which it would have
/// one. Also notes the fence that takes the end's own voxel if obstacles and boundary leave it free.
void Plan::note_narrowness() noexcept {
  const SearchStage& search = memory_->stage.search;
  if (!is_too_narrow(search.status) || escapes_ > 0) return;  // > 0 after the previous plan too: an escape follows it
  const Voxel home = voxels().voxel_of(search.finer.point);
  report_.finer_cell = search.finer.cell;
  narrow_fence_ = grid_->free(home) ? world().first_over(cube_of(*grid_, home)) : kNoFence;
}

/// The via that the failed part of the way leads to, or the via that it begins at if that one cannot be left. kNoVia if
/// that end is the start or the goal.
std::int32_t Plan::via_at_fault(Stage stage) const noexcept {
  const bool on_leg = stage == Stage::kSearch || stage == Stage::kShortcut;
  const Status why = memory_->stage.search.status;
  const bool no_start = why == Status::kStartOccupied || why == Status::kStartTooNarrow;
  const bool at_start = stage == Stage::kSearch && no_start;
  const std::int32_t leg = at_start ? leg_ - 1 : leg_;
  const std::int32_t via = on_leg ? leg : (stage == Stage::kCorridor ? memory_->stage.corridor.passed : via_count());
  return via >= 0 && via < via_count() ? via : kNoVia;
}

/// The plan passes exactly through a via whose voxel is not free. The legs that join such a via to the grid are short,
/// and a programme in which such a leg has free ends is too ill-conditioned.
void Plan::make_holds() noexcept {
  Mission& mission = memory_->mission;
  for (std::int32_t v = 0; v < mission.marks.count; ++v) {
    const Via& via = mission.vias[v];
    const bool free = voxels().free(voxels().voxel_of(to_local(voxels(), via.position)));
    mission.holds[v] = hold_of(via, asked_.start.position, mission.marks.polyhedron[v], free ? reach_of(via) : 0.0);
  }
}

/// Finds the joints where the finished trajectory passes the vias. A stop before the way comes with polyhedra of its
/// own.
void Plan::locate_vias() noexcept {
  Layout& memory = *memory_;
  const Trajectory& trajectory = memory.trajectory;
  int joint = 0;
  for (std::int32_t v = 0; v < via_count(); ++v) {
    const int polyhedron = memory.mission.marks.polyhedron[v] + memory.escapes[0].count;
    while (joint < trajectory.count && trajectory.segments[joint].polyhedron < polyhedron) ++joint;
    memory.mission.joint[v] = joint;
  }
}

/// Finds the vias, and lets the plan rest at those with a dwell. False if one more segment does not fit.
bool Plan::add_dwells() noexcept {
  Layout& memory = *memory_;
  Trajectory& trajectory = memory.trajectory;
  locate_vias();
  std::int32_t added = 0;
  for (std::int32_t v = 0; v < via_count(); ++v) {
    memory.mission.joint[v] += added;
    if (!(memory.mission.vias[v].dwell > 0.0)) continue;
    if (is_full(trajectory.count == kMaxSegments)) return false;
    insert_rest(trajectory, memory.mission.joint[v], memory.mission.vias[v].dwell);
    ++added;
  }
  return true;
}

void Plan::report_vias() noexcept {
  const Mission& mission = memory_->mission;
  const Trajectory& trajectory = memory_->trajectory;
  double time = 0.0;
  int joint = 0;
  for (std::int32_t v = 0; v < via_count(); ++v) {
    for (; joint < mission.joint[v]; ++joint) time += trajectory.segments[joint].duration;
    const Vec3& point = joint < trajectory.count ? trajectory.segments[joint].points[0]
                                                 : trajectory.segments[joint - 1].points[kDegree];
    report_.vias[v] = {time, distance(point, mission.vias[v].position - trajectory.origin)};
  }
}

}  // namespace tern
