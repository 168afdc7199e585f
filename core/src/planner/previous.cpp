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

/// The state at the end of the plan, with the requested motion of the goal.
JointState as_asked(const State& goal, const JointState& end) {
  return {{end.d[0], goal.velocity, goal.acceleration, goal.jerk}};
}

/// The segment that is flown at `time`; `time` becomes the time since its beginning. plan.count if the plan is over.
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

/// The state at a cut.
struct Cut {
  Sample now;
  int first;    ///< the segment that is being flown; plan.count if nothing is left to fly
  double time;  ///< since the beginning of that segment
  Vec3 begin;   ///< the position in the plan's frame
};

Cut cut_at(const Trajectory& plan, double time) {
  Cut cut{evaluate(plan, time), 0, time, {0.0, 0.0, 0.0}};
  cut.first = segment_at(plan, cut.time);
  if (cut.first == plan.count || plan.segments[cut.first].duration - cut.time < kLeastRest) {
    cut.first = plan.count;
  } else {
    cut.begin = value(curve_of(plan.segments[cut.first]), cut.time / plan.segments[cut.first].duration);
  }
  return cut;
}

/// Appends the segment between two states.
void append(const JointState& from, const JointState& to, double duration, Previous& rest) {
  Segment& segment = rest.segments[rest.count++];
  segment.duration = duration;
  control_points(from, to, duration, segment.points);
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
  rest.count = rest.next = rest.enclosed = rest.tries = 0;
  rest.flown = rest.meets_goal = false;
  rest.origin = request.start.position;
  if (request.previous == nullptr) return;
  rest.plan = *request.previous;
  const Trajectory& plan = rest.plan;
  const Cut cut = cut_at(plan, request.previous_time);
  rest.jerk = cut.now.jerk;
  const Vec3 end = (plan.origin - request.start.position) + plan.segments[plan.count - 1].points[kDegree];
  rest.meets_goal = distance(end, request.goal.position - request.start.position) <= contact_tolerance(grid.spec());
  JointState from{{{0.0, 0.0, 0.0}, cut.now.velocity, cut.now.acceleration, cut.now.jerk}};
  for (int i = cut.first; i < plan.count; ++i) {
    JointState to = end_state(plan.segments[i]);
    to.d[0] = to.d[0] - cut.begin;
    if (i + 1 == plan.count && rest.meets_goal) to = as_asked(request.goal, to);
    append(from, to, plan.segments[i].duration - (i == cut.first ? cut.time : 0.0), rest);
    from = to;
  }
}

void cut_in_place(double time, Previous& rest) noexcept {
  const Trajectory& plan = rest.plan;
  const Cut cut = cut_at(plan, time);
  rest.count = rest.next = rest.enclosed = 0;
  rest.origin = plan.origin;
  for (int i = cut.first; i < plan.count; ++i) {
    if (i > cut.first) {
      rest.segments[rest.count++] = plan.segments[i];
      continue;
    }
    const JointState from{{cut.begin, cut.now.velocity, cut.now.acceleration, cut.now.jerk}};
    append(from, end_state(plan.segments[i]), plan.segments[i].duration - cut.time, rest);
  }
}

}  // namespace tern
