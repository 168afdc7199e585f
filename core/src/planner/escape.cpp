// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/escape.hpp"

#include "base/bounds.hpp"
#include "base/capacity.hpp"
#include "curve/motion_limits.hpp"
#include "curve/rest.hpp"
#include "planner/tube.hpp"

namespace tern {
namespace {

void shift(int by, Corridor& corridor, Trajectory& trajectory) {
  for (int i = corridor.count - 1; i >= 0; --i) corridor.polyhedra[i + by] = corridor.polyhedra[i];
  for (int i = trajectory.count - 1; i >= 0; --i) {
    trajectory.segments[i + by] = trajectory.segments[i];
    trajectory.segments[i + by].polyhedron += by;
  }
  corridor.count += by;
  trajectory.count += by;
}

/// Puts the escape at segment and polyhedron `segment_at` and `polyhedron_at`.
void put(const Escape& escape, int segment_at, int polyhedron_at, Corridor& corridor, Trajectory& trajectory) {
  for (int i = 0; i < escape.count; ++i) {
    corridor.polyhedra[polyhedron_at + i] = escape.polyhedra[i];
    trajectory.segments[segment_at + i] = escape.segments[i];
    trajectory.segments[segment_at + i].polyhedron += polyhedron_at;
  }
}

}  // namespace

bool escape_try(const EscapeRoom& room, const State& state, const MotionLimits& limits, GrowScratch& scratch,
                Escape& escape) noexcept {
  const int choice = escape.next++;
  Stopping& stopping = escape.stopping;
  const bool kept = room.to_goal ? make_stopping(backwards(state), backwards(limits), choice, stopping)
                                 : make_stopping(state, limits, choice, stopping);
  if (!kept) return false;
  escape.rest = rest_of(stopping);
  if (room.to_goal) reverse(stopping);
  Tube tube = tube_of(escape, kEscapeSegments);
  bool fits = true;
  for (int i = 0; i < stopping.count && fits; ++i) {
    fits = enclose(room.grid, room.origin, stopping.segments[i], scratch, tube) == Status::kOk;
  }
  escape.count = fits ? tube.count : 0;
  return fits;
}

bool arrive_try(const EscapeRoom& room, const State& start, const State& goal, const MotionLimits& limits, int choice,
                GrowScratch& scratch, Escape& escape) noexcept {
  // Parts of what the way takes at the mean of both velocities.
  constexpr double kParts[kArrivals] = {1.0, 1.01, 0.99, 1.03, 0.97, 1.1, 0.9, 1.25, 0.8, 1.5, 2.0, 3.0};
  const double speed = 0.5 * length(start.velocity + goal.velocity);
  const double way = distance(start.position, goal.position);
  escape.count = 0;
  if (!(speed > 0.0) || !(way > 0.0)) return false;
  Segment segment{};
  segment.duration = kParts[choice] * (way / speed);
  control_points({{start.position, start.velocity, start.acceleration, start.jerk}},
                 {{goal.position, goal.velocity, goal.acceleration, goal.jerk}}, segment.duration, segment.points);
  if (!within_limits(segment, limits, kStopTolerance)) return false;
  Tube tube = tube_of(escape, kEscapeSegments);
  if (enclose(room.grid, room.origin, segment, scratch, tube) != Status::kOk) return false;
  escape.count = tube.count;
  return true;
}

bool add_escapes(const Escape& start, const Escape& goal, Corridor& corridor, Trajectory& trajectory) noexcept {
  const int more = start.count + goal.count;
  if (is_full(corridor.count + more > kMaxSegments || trajectory.count + more > kMaxSegments)) return false;
  shift(start.count, corridor, trajectory);
  put(start, 0, 0, corridor, trajectory);
  put(goal, trajectory.count, corridor.count, corridor, trajectory);
  corridor.count += goal.count;
  trajectory.count += goal.count;
  return true;
}

}  // namespace tern
