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
  // The sum is rounded: the segment may be over although the sum is not reached.
  if (index < plan.count && !(time < plan.segments[index].duration)) {
    time = 0.0;
    ++index;
  }
  return index;
}

Segment first_part(Segment segment, double time) {
  keep_first_part(time / segment.duration, segment.points);
  segment.duration = time;
  return segment;
}

/// From where the last `left` seconds of the segment begin to its end. They are cut off backwards from the end, so that
/// rounding is relative to their own size, however short they are.
Vec3 displacement(const Segment& segment, double left) {
  Vec3 back[kControlPoints];
  for (int k = 0; k < kControlPoints; ++k) back[k] = segment.points[kDegree - k] - segment.points[kDegree];
  keep_first_part(left / segment.duration, back);
  return -1.0 * back[kDegree];
}

/// Where a plan is cut.
struct Cut {
  Sample now;
  Vec3 begin;   ///< the position in the plan's frame
  int segment;  ///< the one that is being flown; plan.count if nothing is left to fly
  double left;  ///< of that segment, seconds
};

Cut cut_at(const Trajectory& plan, double time) {
  Cut cut{evaluate(plan, time), kZero, 0, 0.0};
  double flown = time;
  cut.segment = segment_at(plan, flown);
  if (cut.segment == plan.count) return cut;
  const Segment& segment = plan.segments[cut.segment];
  cut.begin = value(curve_of(segment), flown / segment.duration);
  cut.left = segment.duration - flown;
  if (cut.left < kLeastRest && cut.segment + 1 == plan.count) cut.segment = plan.count;
  return cut;
}

JointState state_of(const Cut& cut) {
  return {{cut.begin, cut.now.velocity, cut.now.acceleration, cut.now.jerk}};
}

/// Appends the segment between two states.
void append(const JointState& from, const JointState& to, double duration, Previous& rest) {
  Segment& segment = rest.segments[rest.count++];
  segment.duration = duration;
  control_points(from, to, duration, segment.points);
}

/// Makes the segments of a plan anew, one after another, relative to where it is cut.
class Rebuilding {
 public:
  Rebuilding(const Cut& cut, const State& goal, Previous& rest)
      : begin_(cut.begin), goal_(goal), rest_(rest), from_(state_of(cut)) {
    from_.d[0] = kZero;
  }

  void fly_to(const JointState& to, double duration) {
    append(from_, to, duration, rest_);
    from_ = to;
  }

  /// A segment to the end of `segment`.
  void fly_to_end(const Segment& segment, double duration, bool is_last) {
    JointState to = end_state(segment);
    to.d[0] = to.d[0] - begin_;
    fly_to(is_last && rest_.meets_goal ? as_asked(goal_, to) : to, duration);
  }

  /// All segments from that one on; of that one, so many seconds.
  void fly_rest(int from, double left) {
    const Trajectory& plan = rest_.plan;
    for (int i = from; i < plan.count; ++i) {
      const Segment& segment = plan.segments[i];
      fly_to_end(segment, i == from ? left : segment.duration, i + 1 == plan.count);
    }
  }

 private:
  Vec3 begin_;
  const State& goal_;
  Previous& rest_;
  JointState from_;
};

/// A remainder that is too short to be made anew from the states at its ends becomes one piece with the beginning of
/// the next segment, unless that was halved until it is too short as well.
bool can_be_joined(const Trajectory& plan, const Cut& cut) {
  return cut.left < kLeastRest && plan.segments[cut.segment + 1].duration >= 2.0 * kJoined;
}

void begin_rest(const Vec3& origin, Previous& rest) {
  rest.count = rest.next = rest.enclosed = 0;
  rest.origin = origin;
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
  begin_rest(request.start.position, rest);
  rest.tries = 0;
  rest.flown = rest.meets_goal = rest.in_place = false;
  if (request.previous == nullptr) return;
  rest.plan = *request.previous;
  const Trajectory& plan = rest.plan;
  const Cut cut = cut_at(plan, request.previous_time);
  rest.jerk = cut.now.jerk;
  const Vec3 end = (plan.origin - request.start.position) + plan.segments[plan.count - 1].points[kDegree];
  rest.meets_goal = distance(end, request.goal.position - request.start.position) <= contact_tolerance(grid.spec());
  if (cut.segment == plan.count) return;
  Rebuilding rebuilding(cut, request.goal, rest);
  if (!can_be_joined(plan, cut)) return rebuilding.fly_rest(cut.segment, cut.left);
  const Segment& next = plan.segments[cut.segment + 1];
  rebuilding.fly_to_end(first_part(next, kJoined), cut.left + kJoined, false);
  rebuilding.fly_rest(cut.segment + 1, next.duration - kJoined);
}

void cut_again(const Request& request, Previous& rest) noexcept {
  const Trajectory& plan = rest.plan;
  const Cut cut = cut_at(plan, request.previous_time);
  const Segment& first = plan.segments[cut.segment];
  rest.in_place = cut.left >= kLeastRest;
  if (rest.in_place) {
    begin_rest(plan.origin, rest);
    append(state_of(cut), end_state(first), cut.left, rest);
    for (int i = cut.segment + 1; i < plan.count; ++i) rest.segments[rest.count++] = plan.segments[i];
  } else {
    begin_rest(request.start.position, rest);
    Rebuilding rebuilding(cut, request.goal, rest);
    JointState joint = end_state(first);
    joint.d[0] = displacement(first, cut.left);
    rebuilding.fly_to(joint, cut.left);
    rebuilding.fly_rest(cut.segment + 1, plan.segments[cut.segment + 1].duration);
  }
}

}  // namespace tern
