// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/previous.hpp"

#include "base/math.hpp"
#include "curve/bezier.hpp"
#include "curve/hermite.hpp"
#include "grid/distance.hpp"

namespace tern {
namespace {

bool is_sound(const Segment& segment) {
  if (!finite(segment.duration) || !(segment.duration > 0.0)) return false;
  for (const Vec3& point : segment.points) {
    if (!finite(point)) return false;
  }
  return true;
}

/// The state at the segment's end.
JointState end_state(const Segment& segment) {
  JointState state;
  Curve curve = curve_of(segment);
  for (Vec3& derivative : state.d) {
    derivative = curve.c[curve.degree];
    curve = hodograph(curve, segment.duration);
  }
  return state;
}

/// The goal's motion as the request has it, where the plan ends.
JointState as_asked(const State& goal, const JointState& end) {
  return {{end.d[0], goal.velocity, goal.acceleration, {0.0, 0.0, 0.0}}};
}

/// The segment that is flown at `time`, which becomes the time since its beginning. All of them have passed: count.
int segment_at(const Trajectory& plan, double& time) {
  double begin = 0.0;
  int index = 0;
  while (index < plan.count && time >= begin + plan.segments[index].duration) {
    begin += plan.segments[index].duration;
    ++index;
  }
  time -= begin;
  return index;
}

}  // namespace

bool previous_fits(const Request& request) noexcept {
  const Trajectory& plan = *request.previous;
  if (plan.count < 1 || plan.count > kMaxSegments || !finite(plan.origin)) return false;
  for (int i = 0; i < plan.count; ++i) {
    if (!is_sound(plan.segments[i])) return false;
  }
  const Sample state = evaluate(plan, request.previous_time);
  return request.previous_time >= 0.0 && same(state.position, request.start.position) &&
         same(state.velocity, request.start.velocity) && same(state.acceleration, request.start.acceleration);
}

void cut_previous(const Grid& grid, const Request& request, Previous& rest) noexcept {
  rest.count = rest.next = rest.enclosed = 0;
  rest.tried = rest.flown = rest.meets_goal = false;
  if (request.previous == nullptr) return;
  const Trajectory& plan = *request.previous;
  const Sample now = evaluate(plan, request.previous_time);
  rest.jerk = now.jerk;
  double time = request.previous_time;
  const int first = segment_at(plan, time);
  if (first == plan.count || plan.segments[first].duration - time < kLeastRest) return;
  const Vec3 way = (plan.origin - request.start.position) + plan.segments[plan.count - 1].points[kDegree];
  rest.meets_goal = distance(way, request.goal.position - request.start.position) <= contact_tolerance(grid.spec());
  const Vec3 begin = value(curve_of(plan.segments[first]), time / plan.segments[first].duration);
  JointState from{{{0.0, 0.0, 0.0}, now.velocity, now.acceleration, now.jerk}};
  for (int i = first; i < plan.count; ++i) {
    JointState to = end_state(plan.segments[i]);
    to.d[0] = to.d[0] - begin;
    if (i + 1 == plan.count && rest.meets_goal) to = as_asked(request.goal, to);
    Segment& segment = rest.segments[rest.count++];
    segment.duration = plan.segments[i].duration - (i == first ? time : 0.0);
    control_points(from, to, segment.duration, segment.points);
    from = to;
  }
}

}  // namespace tern
