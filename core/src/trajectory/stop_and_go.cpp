// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/stop_and_go.hpp"

#include "base/bounds.hpp"
#include "times/times.hpp"
#include "trajectory/hermite.hpp"
#include "trajectory/motion_limits.hpp"

namespace tern {
namespace {

/// Durations tried for a braking segment, each longer than the one before by kBrakeStep: a factor of 60 in all.
constexpr int kBrakeTries = 44;
constexpr double kBrakeStep = 1.1;

constexpr Vec3 kZero{0.0, 0.0, 0.0};

bool is_zero(const Vec3& v) {
  return !(dot(v, v) > 0.0);
}

bool same_point(const Vec3& a, const Vec3& b) {
  return is_zero(a - b);
}

/// Seconds below which no braking from that state can keep the limits.
double least_braking_time(const State& state, const Limits& limits) {
  return larger(kMinDuration, gauge(acceleration_bounds(limits), kZero - state.velocity));
}

/// The first four control points follow from the state, the last four are where it stops: half a step past the fourth,
/// which makes the slowing down symmetric in time for a start without acceleration.
Segment braking_curve(const State& state, int polyhedron, double duration) {
  Segment segment{};
  segment.duration = duration;
  segment.polyhedron = polyhedron;
  const JointState start{{state.position, state.velocity, state.acceleration, kZero}};
  control_points(start, start, duration, segment.points);
  const Vec3 stop = segment.points[3] + 0.5 * (segment.points[3] - segment.points[2]);
  for (int k = kJointOrder; k <= kDegree; ++k) segment.points[k] = stop;
  return segment;
}

/// The same path flown backwards.
void reverse(Segment& segment) {
  for (int k = 0; k < kJointOrder; ++k) {
    const Vec3 first = segment.points[k];
    segment.points[k] = segment.points[kDegree - k];
    segment.points[kDegree - k] = first;
  }
}

State backwards(const State& state) {
  return State{state.position, kZero - state.velocity, state.acceleration};
}

/// End of leg i of the way along the corridor's waypoints to `to`.
const Vec3& leg_end(const Corridor& corridor, const Vec3& to, int i) {
  return i + 1 < corridor.count ? corridor.polyhedra[i].to : to;
}

/// Legs of a length.
int count_legs(const Corridor& corridor, Vec3 from, const Vec3& to) {
  int legs = 0;
  for (int i = 0; i < corridor.count; ++i) {
    if (!same_point(from, leg_end(corridor, to, i))) ++legs;
    from = leg_end(corridor, to, i);
  }
  return legs;
}

void append(const Segment& segment, Trajectory& out) {
  out.segments[out.count] = segment;
  ++out.count;
}

void append_legs(const Corridor& corridor, Vec3 from, const Vec3& to, const Limits& limits, Trajectory& out) {
  for (int i = 0; i < corridor.count; ++i) {
    const Vec3 next = leg_end(corridor, to, i);
    if (!same_point(from, next)) append(straight_segment(from, next, i, limits), out);
    from = next;
  }
}

}  // namespace

bool at_rest(const State& state) noexcept {
  return is_zero(state.velocity) && is_zero(state.acceleration);
}

Segment straight_segment(const Vec3& from, const Vec3& to, int polyhedron, const Limits& limits) noexcept {
  Segment segment{};
  segment.polyhedron = polyhedron;
  const Vec3 way = to - from;
  const Bounds acceleration = acceleration_bounds(limits);
  const double pull = larger(gauge(acceleration, way), gauge(acceleration, kZero - way));
  const double cruise = kRestPeakSpeed * gauge(velocity_bounds(limits), way);
  segment.duration = larger(kMinDuration, larger(cruise, square_root(kRestPeakAcceleration * pull)));
  for (int k = 0; k < kJointOrder; ++k) {
    segment.points[k] = from;
    segment.points[kDegree - k] = to;
  }
  return segment;
}

bool brake_segment(const State& state, const Polyhedron& polyhedron, int index, const Limits& limits,
                   Segment& segment) noexcept {
  double time = least_braking_time(state, limits);
  for (int i = 0; i < kBrakeTries; ++i) {
    segment = braking_curve(state, index, time);
    if (inside(segment, polyhedron) && within_limits(segment, limits)) return true;
    time *= kBrakeStep;
  }
  return false;
}

Status stop_and_go(const Corridor& corridor, const State& start, const State& goal, const Limits& limits,
                   Trajectory& out) noexcept {
  const int last = corridor.count - 1;
  const bool brakes = !at_rest(start);
  const bool launches = !at_rest(goal);
  Segment brake{};
  Segment launch{};
  if (brakes && !brake_segment(start, corridor.polyhedra[0], 0, limits, brake)) return Status::kNoTrajectory;
  if (launches && !brake_segment(backwards(goal), corridor.polyhedra[last], last, backwards(limits), launch)) {
    return Status::kNoTrajectory;
  }
  const Vec3 from = brakes ? brake.points[kDegree] : start.position;
  const Vec3 to = launches ? launch.points[kDegree] : goal.position;
  const int count = count_legs(corridor, from, to) + (brakes ? 1 : 0) + (launches ? 1 : 0);
  if (count > kMaxSegments) return Status::kNoTrajectory;
  out.count = 0;
  if (brakes) append(brake, out);
  append_legs(corridor, from, to, limits, out);
  if (launches) {
    reverse(launch);
    append(launch, out);
  }
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
