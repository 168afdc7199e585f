// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/detour.hpp"

#include "base/bounds.hpp"
#include "base/capacity.hpp"
#include "curve/rest.hpp"
#include "grid/distance.hpp"
#include "path/polyline.hpp"
#include "path/sight.hpp"
#include "planner/validate.hpp"

namespace tern {
namespace {

/// The world that lines are checked against, and the work that the checks spend.
struct Lines {
  const World& world;
  Work& work;
};

/// A braking motion needs only the radius, like a start that is not in a free voxel.
bool can_brake_along(Lines& lines, const Vec3& from, const Vec3& to) {
  const GridSpec& spec = lines.world.spec();
  lines.work.spend(clear_operations(spec, to - from, spec.clearance()));
  return lines.world.line_clear(from, to);
}

/// Legs of a path keep the margin that gives neighbouring polyhedra room in common.
bool can_lead_on(Lines& lines, const Vec3& from, const Vec3& to) {
  lines.work.spend(sight_operations(lines.world.voxels(), from, to));
  return line_of_sight(lines.world.voxels(), from, to) && lines.world.solids_clear(from, to);
}

/// The stopping point of the sharpest braking that has room straight ahead. Whatever the acceleration, this braking
/// leads nearly along the velocity. The polyhedron around it also has room for gentler braking, as far as it reaches. A
/// stop that lies beyond the boundary by rounding is put on it: far from the world's origin, it may be further out than
/// the check tolerates.
bool find_stop(Lines& lines, const State& state, const MotionLimits& limits, Vec3& stop) {
  for (int shape = kBrakeShapes - 1; shape >= 0; --shape) {
    const Vec3 end = stopping_point(make_brake(state, limits, shape));
    stop = nearest_in_box(end, lines.world.voxels().local_boundary());
    if (can_brake_along(lines, state.position, end)) return true;
  }
  return false;
}

/// Index of the furthest waypoint that `point` sees, at most `last`; 0 if it sees none. The path reaches `point` from
/// waypoint 0.
int onward_waypoint(Lines& lines, const Vec3& point, const Path& path, int last) {
  const int furthest = last < kOnwardWaypoints ? last : kOnwardWaypoints;
  for (int k = furthest; k > 0; --k) {
    if (can_lead_on(lines, point, path.points[k])) return k;
  }
  return 0;
}

/// Replaces the waypoints between the first one and `next` by `stop`. If `next` is the first one, the path then visits
/// it twice. Works in place: the waypoints after `next` move towards the end if the path grows, otherwise towards the
/// beginning.
void insert_stop(const Vec3& stop, int next, Path& path) {
  const int shift = 2 - next;
  const int moved = path.count - next;
  for (int i = 0; i < moved; ++i) {
    const int k = shift > 0 ? path.count - 1 - i : next + i;
    path.points[k + shift] = path.points[k];
  }
  path.points[1] = stop;
  path.count += shift;
}

void reverse(Path& path) {
  for (int k = 0; 2 * k < path.count - 1; ++k) {
    const Vec3 point = path.points[k];
    path.points[k] = path.points[path.count - 1 - k];
    path.points[path.count - 1 - k] = point;
  }
}

/// The detour at the first end of the path. Waypoints after `last` stay.
bool lead_through_stop(Lines& lines, const State& start, const MotionLimits& limits, int last, Path& path) {
  Vec3 stop;
  if (at_rest(start) || is_full(path.count + 2 > kMaxWaypoints) || !find_stop(lines, start, limits, stop)) return false;
  insert_stop(stop, onward_waypoint(lines, stop, path, last), path);
  return true;
}

}  // namespace

bool take_detour(const World& world, const Request& request, const MotionLimits& limits, Path& path,
                 Work& work) noexcept {
  Lines checked{world, work};
  work.spend(2 * kBrakeShapes * ops::kCurve);
  const bool start_led = lead_through_stop(checked, request.start, limits, path.count - 1, path);
  reverse(path);
  // The start's own leg stays, whatever the stopping point of the goal can see.
  const int last = path.count - (start_led ? 2 : 1);
  const bool goal_led = lead_through_stop(checked, backwards(request.goal), backwards(limits), last, path);
  reverse(path);
  if (!start_led && !goal_led) return false;
  path.length = polyline_length(path.points, path.count);
  return true;
}

bool detour_may_help(const Problem& problem, const Detour& detour) noexcept {
  return !detour.tried && problem.via_count == 0;
}

void detour_begin(Status why, Detour& detour) noexcept {
  detour = {true, why};
}

Progress detour_advance(const Problem& problem, Path& path, Work& work) noexcept {
  if (!work.left()) return Progress::kMore;
  const Request local = to_local(voxels_of(problem), problem.asked);
  const bool found = take_detour(world_of(problem), local, problem.limits, path, work);
  return found ? Progress::kDone : Progress::kFailed;
}

}  // namespace tern
