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

/// How much of the next segment is joined to a remainder that is too short, seconds.
constexpr double kJoined = 2e-3;

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

Segment first_part(Segment segment, double time) {
  keep_first_part(time / segment.duration, segment.points);
  segment.duration = time;
  return segment;
}

Segment last_part(Segment segment, double from) {
  keep_last_part(from / segment.duration, segment.points);
  segment.duration -= from;
  return segment;
}

/// Where a plan is cut.
struct Cut {
  Sample now;
  Vec3 begin;     ///< the position in the plan's frame
  int segment;    ///< the one in which the first piece of the rest ends; plan.count if nothing is left to fly
  double joined;  ///< how much of its beginning belongs to that piece, seconds; 0: all that is left of it
  double left;    ///< the duration of the piece, seconds
};

/// A remainder that is too short to be cut off is joined to the beginning of the next segment. If that was halved until
/// it is too short as well, the remainder is cut off nevertheless, and the check decides.
Cut cut_at(const Trajectory& plan, double time) {
  Cut cut{evaluate(plan, time), kZero, 0, 0.0, 0.0};
  double flown = time;
  cut.segment = segment_at(plan, flown);
  if (cut.segment == plan.count) return cut;
  const Segment& segment = plan.segments[cut.segment];
  cut.begin = value(curve_of(segment), flown / segment.duration);
  cut.left = segment.duration - flown;
  if (cut.left >= kLeastRest) return cut;
  const int next = cut.segment + 1;
  if (next < plan.count && plan.segments[next].duration < 2.0 * kJoined) return cut;
  cut.joined = kJoined;
  cut.left += kJoined;
  cut.segment = next;
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
  JointState from{{kZero, cut.now.velocity, cut.now.acceleration, cut.now.jerk}};
  const auto fly_to_end = [&](const Segment& segment, double duration, bool is_last) {
    JointState to = end_state(segment);
    to.d[0] = to.d[0] - cut.begin;
    if (is_last && rest.meets_goal) to = as_asked(request.goal, to);
    append(from, to, duration, rest);
    from = to;
  };
  if (cut.segment == plan.count) return;
  const Segment& first = plan.segments[cut.segment];
  const bool joins = cut.joined > 0.0;
  if (joins) fly_to_end(first_part(first, cut.joined), cut.left, false);
  for (int i = cut.segment; i < plan.count; ++i) {
    const double whole = plan.segments[i].duration;
    const double part = joins ? whole - cut.joined : cut.left;
    fly_to_end(plan.segments[i], i == cut.segment ? part : whole, i + 1 == plan.count);
  }
}

void cut_in_place(double time, Previous& rest) noexcept {
  const Trajectory& plan = rest.plan;
  const Cut cut = cut_at(plan, time);
  rest.count = rest.next = rest.enclosed = 0;
  rest.origin = plan.origin;
  if (cut.segment == plan.count) return;
  const JointState from{{cut.begin, cut.now.velocity, cut.now.acceleration, cut.now.jerk}};
  const Segment& first = plan.segments[cut.segment];
  const bool joins = cut.joined > 0.0;
  append(from, end_state(joins ? first_part(first, cut.joined) : first), cut.left, rest);
  if (joins) rest.segments[rest.count++] = last_part(first, cut.joined);
  for (int i = cut.segment + 1; i < plan.count; ++i) rest.segments[rest.count++] = plan.segments[i];
}

}  // namespace tern
