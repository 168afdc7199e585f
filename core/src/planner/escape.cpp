// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/escape.hpp"

#include "base/bounds.hpp"
#include "corridor/hull_polyhedron.hpp"
#include "trajectory/bezier.hpp"
#include "trajectory/motion_limits.hpp"
#include "trajectory/stop_and_go.hpp"

namespace tern {
namespace {

/// Appends the segment with a polyhedron around its hull.
bool append(const EscapeRoom& room, const Segment& segment, GrowScratch& scratch, Escape& escape) {
  Vec3 points[kControlPoints];
  for (int k = 0; k < kControlPoints; ++k) points[k] = room.origin + segment.points[k];
  Polyhedron& polyhedron = escape.polyhedra[escape.count];
  if (enclose_hull(room.grid, {points, kControlPoints}, scratch, polyhedron) != Status::kOk) return false;
  escape.segments[escape.count] = segment;
  escape.segments[escape.count].polyhedron = escape.count;
  ++escape.count;
  return true;
}

Segment half_of(const Segment& whole, const Curve& curve) {
  Segment segment = whole;
  segment.duration = 0.5 * whole.duration;
  for (int k = 0; k < kControlPoints; ++k) segment.points[k] = curve.c[k];
  return segment;
}

/// Segments that wait for a polyhedron, the next one last.
struct Pending {
  int count;
  Segment segment[kEscapeHalvings + 1];
  int halvings[kEscapeHalvings + 1];

  void push(const Segment& next, int halved) {
    segment[count] = next;
    halvings[count++] = halved;
  }
};

/// As a whole where that has room, else in halves, and so on. Each turn appends a segment or halves one; segments that
/// do not fit end it.
bool append_in_parts(const EscapeRoom& room, const Segment& whole, GrowScratch& scratch, Escape& escape) {
  Pending pending;
  pending.count = 0;
  pending.push(whole, 0);
  while (pending.count > 0) {
    if (escape.count + pending.count > kEscapeSegments) return false;
    const Segment segment = pending.segment[--pending.count];
    const int halvings = pending.halvings[pending.count];
    if (append(room, segment, scratch, escape)) continue;
    if (halvings == kEscapeHalvings) return false;
    Curve first = curve_of(segment);
    const Curve second = split(first);
    pending.push(half_of(segment, second), halvings + 1);
    pending.push(half_of(segment, first), halvings + 1);
  }
  return true;
}

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

bool escape_try(const EscapeRoom& room, const State& state, const Limits& limits, GrowScratch& scratch,
                Escape& escape) noexcept {
  const int choice = escape.next++;
  Stopping& stopping = escape.stopping;
  const bool kept = room.to_goal ? make_stopping(backwards(state), backwards(limits), choice, stopping)
                                 : make_stopping(state, limits, choice, stopping);
  if (!kept) return false;
  escape.rest = rest_of(stopping);
  if (room.to_goal) reverse(stopping);
  escape.count = 0;
  for (int i = 0; i < stopping.count; ++i) {
    if (append_in_parts(room, stopping.segments[i], scratch, escape)) continue;
    escape.count = 0;
    return false;
  }
  return true;
}

bool arrive_try(const EscapeRoom& room, const State& start, const State& goal, const Limits& limits, int choice,
                GrowScratch& scratch, Escape& escape) noexcept {
  // Parts of what the way takes at the mean of both velocities.
  constexpr double kParts[kArrivals] = {1.0, 1.01, 0.99, 1.03, 0.97, 1.1, 0.9, 1.25, 0.8, 1.5, 2.0, 3.0};
  const double speed = 0.5 * length(start.velocity + goal.velocity);
  const double way = distance(start.position, goal.position);
  escape.count = 0;
  if (!(speed > 0.0) || !(way > 0.0)) return false;
  constexpr Vec3 kZero{0.0, 0.0, 0.0};
  Segment segment{};
  segment.duration = kParts[choice] * (way / speed);
  control_points({{start.position, start.velocity, start.acceleration, kZero}},
                 {{goal.position, goal.velocity, goal.acceleration, kZero}}, segment.duration, segment.points);
  if (!within_limits(segment, limits, kStopTolerance)) return false;
  if (append_in_parts(room, segment, scratch, escape)) return true;
  escape.count = 0;
  return false;
}

bool add_escapes(const Escape& start, const Escape& goal, Corridor& corridor, Trajectory& trajectory) noexcept {
  const int more = start.count + goal.count;
  if (corridor.count + more > kMaxSegments || trajectory.count + more > kMaxSegments) return false;
  shift(start.count, corridor, trajectory);
  put(start, 0, 0, corridor, trajectory);
  put(goal, trajectory.count, corridor.count, corridor, trajectory);
  corridor.count += goal.count;
  trajectory.count += goal.count;
  return true;
}

}  // namespace tern
