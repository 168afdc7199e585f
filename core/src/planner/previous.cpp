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

/// The segment that is flown at `time`; `time` becomes the time since its beginning. plan.count if the plan is over.
int segment_at(const Trajectory& plan, double& time) {
  double begin = 0.0;
  int index = 0;
  while (index < plan.count && time >= begin + plan.segments[index].duration) {
    begin += plan.segments[index].duration;
    ++index;
  }
  time -= begin;
  // The sum is rounded: the segment may be over although the sum is not reached.
  if (index < plan.count && !(time < plan.segments[index].duration)) {
    time = 0.0;
    ++index;
  }
  return index;
}

/// Where a plan is cut.
struct Cut {
  Sample now;
  int segment;  ///< the one that is being flown; plan.count if nothing is left to fly
  double left;  ///< of that segment, seconds
};

Cut cut_at(const Trajectory& plan, double time) {
  Cut cut{evaluate(plan, time), 0, 0.0};
  double flown = time;
  cut.segment = segment_at(plan, flown);
  if (cut.segment == plan.count) return cut;
  cut.left = plan.segments[cut.segment].duration - flown;
  return cut;
}

/// Appends the segment between two states.
void append(const JointState& from, const JointState& to, double duration, Previous& rest) {
  Segment& segment = rest.segments[rest.count++];
  segment.duration = duration;
  segment.polyhedron = kNoPolyhedron;
  control_points(from, to, duration, segment.points);
}

/// By how much the segment moves in its last `time` seconds.
Vec3 last_move(const Segment& segment, double time) {
  Vec3 back[kControlPoints];
  for (int k = 0; k < kControlPoints; ++k) back[k] = segment.points[kDegree] - segment.points[kDegree - k];
  keep_first_part(time / segment.duration, back);
  return back[kDegree];
}

/// The state at the end of the segment. It is taken from the longer of the two segments that meet there, which is
/// rounded less.
JointState joint_behind(const Trajectory& plan, int segment) {
  const bool longer_follows =
      segment + 1 < plan.count && plan.segments[segment + 1].duration > plan.segments[segment].duration;
  return longer_follows ? state_at(plan.segments[segment + 1], 0.0) : state_at(plan.segments[segment], 1.0);
}

/// True if the plan ends at the goal, in the goal's motion: the control points that hold both are where the goal puts
/// them, as near as a start or a goal may touch something.
bool ends_at(const State& goal, const Trajectory& plan, double tolerance) {
  const Segment& last = plan.segments[plan.count - 1];
  const JointState asked{{goal.position - plan.origin, goal.velocity, goal.acceleration, goal.jerk}};
  Vec3 points[kControlPoints];
  control_points(asked, asked, last.duration, points);
  for (int k = kControlPoints - kJointOrder; k < kControlPoints; ++k) {
    if (!(distance(points[k], last.points[k]) <= tolerance)) return false;
  }
  return true;
}

/// Appends what is left of the plan, from the requested start, which is its origin. Each segment is placed by how far
/// it moves, so that its rounding does not depend on where in the plan it lies.
void append_moves(const Cut& cut, Previous& rest) {
  const Trajectory& plan = rest.plan;
  if (cut.segment + 1 == plan.count && cut.left < kLeastRest) return;
  JointState from{{kZero, cut.now.velocity, cut.now.acceleration, cut.now.jerk}};
  for (int i = cut.segment; i < plan.count; ++i) {
    const double left = i == cut.segment ? cut.left : plan.segments[i].duration;
    JointState to = joint_behind(plan, i);
    to.d[0] = from.d[0] + last_move(plan.segments[i], left);
    append(from, to, left, rest);
    from = to;
  }
}

}  // namespace

bool is_trajectory(const Trajectory& plan) noexcept {
  if (plan.count < 1 || plan.count > kMaxSegments || !finite(plan.origin)) return false;
  for (int i = 0; i < plan.count; ++i) {
    if (!is_sound(plan.segments[i])) return false;
  }
  return true;
}

bool previous_fits(const Request& request) noexcept {
  const Trajectory& plan = *request.previous;
  if (!is_trajectory(plan)) return false;
  const Sample state = evaluate(plan, request.previous_time);
  return request.previous_time >= 0.0 && same(state.position, request.start.position) &&
         same(state.velocity, request.start.velocity) && same(state.acceleration, request.start.acceleration);
}

void take_rest(const Grid& grid, const Request& request, Previous& rest) noexcept {
  rest.count = 0;
  rest.tried = rest.meets_goal = false;
  if (request.previous == nullptr) return;
  rest.plan = *request.previous;
  const Trajectory& plan = rest.plan;
  const Cut cut = cut_at(plan, request.previous_time);
  rest.jerk = cut.now.jerk;
  if (cut.segment == plan.count) return;
  rest.meets_goal = ends_at(request.goal, plan, contact_tolerance(grid.spec()));
  if (!rest.meets_goal) append_moves(cut, rest);
}

}  // namespace tern
