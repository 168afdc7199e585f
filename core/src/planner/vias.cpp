// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/vias.hpp"

#include "base/capacity.hpp"
#include "base/math.hpp"
#include "planner/validate.hpp"

namespace tern {
namespace {

/// Half the edge of the cube that fits into the ball of a via's tolerance, less a reserve: the solver may leave the
/// cube by a nanometre.
double half_edge_of(const Via& via) {
  constexpr double kRootThree = 1.7320508075688774;
  constexpr double kSolverReserve = 2e-9;
  return via.tolerance < kLeastTolerance ? 0.0 : via.tolerance / kRootThree - kSolverReserve;
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

/// The segments of a stop before the way come before every via: kNoPolyhedron is less than any index.
void locate_vias(const Problem& problem, const Trajectory& trajectory, ViaMemory& memory) {
  int joint = 0;
  for (std::int32_t v = 0; v < problem.via_count; ++v) {
    const int polyhedron = memory.marks.polyhedron[v];
    while (joint < trajectory.count && trajectory.segments[joint].polyhedron < polyhedron) ++joint;
    memory.joint[v] = joint;
  }
}

}  // namespace

ViaJoints make_via_joints(const Problem& problem, ViaMemory& memory) noexcept {
  const Grid& world = voxels_of(problem);
  for (std::int32_t v = 0; v < problem.via_count; ++v) {
    const Via& via = problem.vias[v];
    const bool free = world.free(world.voxel_of(to_local(world, via.position)));
    memory.via_joints[v] = {memory.marks.polyhedron[v],
                            0,
                            via.position - problem.asked.start.position,
                            free ? half_edge_of(via) : 0.0,
                            via.stop,
                            via.has_velocity,
                            via.velocity};
  }
  return {memory.via_joints, problem.via_count};
}

bool add_dwells(const Problem& problem, ViaMemory& memory, Trajectory& trajectory) noexcept {
  locate_vias(problem, trajectory, memory);
  std::int32_t added = 0;
  for (std::int32_t v = 0; v < problem.via_count; ++v) {
    memory.joint[v] += added;
    if (!(problem.vias[v].dwell > 0.0)) continue;
    if (is_full(trajectory.count == kMaxSegments)) return false;
    insert_rest(trajectory, memory.joint[v], problem.vias[v].dwell);
    ++added;
  }
  return true;
}

void write_passages(const Problem& problem, const ViaMemory& memory, const Trajectory& trajectory,
                    ViaPassage* passages) noexcept {
  double time = 0.0;
  int joint = 0;
  for (std::int32_t v = 0; v < problem.via_count; ++v) {
    for (; joint < memory.joint[v]; ++joint) time += trajectory.segments[joint].duration;
    const Vec3& point = joint < trajectory.count ? trajectory.segments[joint].points[0]
                                                 : trajectory.segments[joint - 1].points[kDegree];
    passages[v] = {time, distance(point, problem.vias[v].position - trajectory.origin)};
  }
}

}  // namespace tern
