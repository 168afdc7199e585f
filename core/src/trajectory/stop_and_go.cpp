// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/stop_and_go.hpp"

#include "base/bounds.hpp"
#include "base/capacity.hpp"
#include "curve/brake.hpp"
#include "curve/rest.hpp"

namespace tern {
namespace {

/// End of leg i of the way along the corridor's waypoints to `to`.
const Vec3& leg_end(const Corridor& corridor, const Vec3& to, int i) {
  return i + 1 < corridor.count ? corridor.polyhedra[i].to : to;
}

/// The number of legs whose length is not zero.
int count_legs(const Corridor& corridor, Vec3 from, const Vec3& to) {
  int legs = 0;
  for (int i = 0; i < corridor.count; ++i) {
    if (!same(from, leg_end(corridor, to, i))) ++legs;
    from = leg_end(corridor, to, i);
  }
  return legs;
}

void append(const Segment& segment, Trajectory& out) {
  out.segments[out.count] = segment;
  ++out.count;
}

void append_brake(const Brake& brake, Trajectory& out) {
  for (int part = 0; part < kBrakeSegments; ++part) append(brake_segment(brake, part, 0), out);
}

/// A braking flown backwards in time.
void append_launch(const Brake& brake, int polyhedron, Trajectory& out) {
  for (int part = kBrakeSegments - 1; part >= 0; --part) {
    append(reversed(brake_segment(brake, part, polyhedron)), out);
  }
}

void append_legs(const Corridor& corridor, Vec3 from, const Vec3& to, const MotionLimits& limits, Trajectory& out) {
  for (int i = 0; i < corridor.count; ++i) {
    const Vec3 next = leg_end(corridor, to, i);
    if (!same(from, next)) append(straight_segment(from, next, i, limits), out);
    from = next;
  }
}

}  // namespace

Status stop_and_go(const Corridor& corridor, const State& start, const State& goal, const MotionLimits& limits,
                   Trajectory& out) noexcept {
  const int last = corridor.count - 1;
  const bool brakes = !at_rest(start);
  const bool launches = !at_rest(goal);
  Brake brake{};
  Brake launch{};
  if (brakes && !find_brake(start, corridor.polyhedra[0], limits, brake)) return Status::kNoTrajectory;
  if (launches && !find_brake(backwards(goal), corridor.polyhedra[last], backwards(limits), launch)) {
    return Status::kNoTrajectory;
  }
  const Vec3 from = brakes ? stopping_point(brake) : start.position;
  const Vec3 to = launches ? stopping_point(launch) : goal.position;
  const int count = count_legs(corridor, from, to) + kBrakeSegments * ((brakes ? 1 : 0) + (launches ? 1 : 0));
  if (is_full(count > kMaxSegments)) return Status::kSegmentsFull;
  out.count = 0;
  if (brakes) append_brake(brake, out);
  append_legs(corridor, from, to, limits, out);
  if (launches) append_launch(launch, last, out);
  if (count == 0) hover(from, out);
  return Status::kOk;
}

void hover(const Vec3& point, Trajectory& out) noexcept {
  out.count = 1;
  out.segments[0].duration = kHoverDuration;
  out.segments[0].polyhedron = 0;
  for (Vec3& control : out.segments[0].points) control = point;
}

}  // namespace tern
