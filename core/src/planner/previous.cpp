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

/// How much of the next segment is joined to a remainder that is too short, seconds, try by try. A longer piece is
/// rounded less; a shorter one deviates less where the plan flies at a limit and the snap jumps.
constexpr double kJoined[kPreviousTries] = {2e-3, 2e-4, 2e-5, 2e-6, 0.0, 2e-3};

/// The state at u in [0, 1] of the segment.
JointState state_at(const Segment& segment, double u) {
  JointState state;
  Curve curve = curve_of(segment);
  for (Vec3& derivative : state.d) {
    derivative = value(curve, u);
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

Segment last_part(Segment segment, double from) {
  keep_last_part(from / segment.duration, segment.points);
  segment.duration -= from;
  return segment;
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

/// By how much the segment moves in its first `time` seconds. Rounding is relative to this distance, however small it
/// is.
Vec3 first_move(const Segment& segment, double time) {
  Vec3 ahead[kControlPoints];
  for (int k = 0; k < kControlPoints; ++k) ahead[k] = segment.points[k] - segment.points[0];
  keep_first_part(time / segment.duration, ahead);
  return ahead[kDegree];
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

/// Appends the segments of the rest one after another. Each is placed by how far it moves, so that its rounding does
/// not depend on where in the plan it lies.
class Moves {
 public:
  Moves(const Cut& cut, Previous& rest) : rest_(rest), from_(state_of(cut)) { from_.d[0] = kZero; }

  void append_move(const Vec3& move, JointState to, double duration) {
    to.d[0] = from_.d[0] + move;
    append(from_, to, duration, rest_);
    from_ = to;
  }

 private:
  Previous& rest_;
  JointState from_;
};

/// Appends what is left of the segment that is being flown, in one piece with the first `joined` >= 0 seconds of the
/// next one, and then the other segments. If the rest ends at the goal, its end has the requested motion of the goal.
void append_moves(const Cut& cut, double joined, const State& goal, Previous& rest) {
  const Trajectory& plan = rest.plan;
  Vec3 move = last_move(plan.segments[cut.segment], cut.left);
  JointState to = joint_behind(plan, cut.segment);
  if (joined > 0.0) {
    const Segment& next = plan.segments[cut.segment + 1];
    move = move + first_move(next, joined);
    to = state_at(next, joined / next.duration);
  } else if (cut.segment + 1 == plan.count && rest.meets_goal) {
    to = as_asked(goal, to);
  }
  Moves moves(cut, rest);
  moves.append_move(move, to, cut.left + joined);
  for (int i = cut.segment + 1; i < plan.count; ++i) {
    const Segment& segment = plan.segments[i];
    const double left = i == cut.segment + 1 ? segment.duration - joined : segment.duration;
    JointState end = joint_behind(plan, i);
    if (i + 1 == plan.count && rest.meets_goal) end = as_asked(goal, end);
    moves.append_move(last_move(segment, left), end, left);
  }
}

/// How much of the next segment is joined to the remainder, seconds; 0 if the next segment is too short as well, after
/// halvings.
double joined_at(const Trajectory& plan, const Cut& cut, int attempt) {
  return plan.segments[cut.segment + 1].duration < 2.0 * kJoined[0] ? 0.0 : kJoined[attempt];
}

void begin_rest(const Vec3& origin, Previous& rest) {
  rest.count = rest.next = rest.enclosed = 0;
  rest.origin = origin;
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

void cut_previous(const Grid& grid, const Request& request, Previous& rest) noexcept {
  begin_rest(request.start.position, rest);
  rest.tries = rest.last_try = 0;
  rest.meets_goal = rest.in_own_frame = false;
  if (request.previous == nullptr) return;
  rest.plan = *request.previous;
  const Trajectory& plan = rest.plan;
  const Cut cut = cut_at(plan, request.previous_time);
  rest.jerk = cut.now.jerk;
  const Vec3 end = (plan.origin - request.start.position) + plan.segments[plan.count - 1].points[kDegree];
  rest.meets_goal = distance(end, request.goal.position - request.start.position) <= contact_tolerance(grid.spec());
  if (cut.segment == plan.count) return;
  rest.last_try = cut.left < kLeastRest ? kPreviousTries : kLongRestTries;
  if (cut.left < kLeastRest) return append_moves(cut, joined_at(plan, cut, 0), request.goal, rest);
  JointState from = state_of(cut);
  from.d[0] = kZero;
  for (int i = cut.segment; i < plan.count; ++i) {
    const Segment& segment = plan.segments[i];
    JointState to = state_at(segment, 1.0);
    to.d[0] = to.d[0] - cut.begin;
    if (i + 1 == plan.count && rest.meets_goal) to = as_asked(request.goal, to);
    append(from, to, i == cut.segment ? cut.left : segment.duration, rest);
    from = to;
  }
}

void cut_again(const Request& request, Previous& rest) noexcept {
  const Trajectory& plan = rest.plan;
  const Cut cut = cut_at(plan, request.previous_time);
  const bool is_short = cut.left < kLeastRest;
  const double joined = is_short ? joined_at(plan, cut, rest.tries - 1) : 0.0;
  rest.in_own_frame = rest.tries == (is_short ? kPreviousTries : kLongRestTries - 1);
  begin_rest(rest.in_own_frame ? plan.origin : request.start.position, rest);
  if (!rest.in_own_frame) return append_moves(cut, joined, request.goal, rest);
  int next = cut.segment + 1;
  if (joined > 0.0) {
    const Segment& after = plan.segments[next++];
    append(state_of(cut), state_at(after, joined / after.duration), cut.left + joined, rest);
    rest.segments[rest.count++] = last_part(after, joined);
  } else {
    append(state_of(cut), state_at(plan.segments[cut.segment], 1.0), cut.left, rest);
  }
  for (int i = next; i < plan.count; ++i) rest.segments[rest.count++] = plan.segments[i];
}

}  // namespace tern
