// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "times/times_stage.hpp"

#include "base/bounds.hpp"
#include "times/time_unit.hpp"
#include "times/trapezoid.hpp"

namespace tern {
namespace {

/// Ratio of the first durations to those of the trapezoid. A curve of degree 7 needs a higher peak for the same way,
/// and durations that are too short to be feasible cost more than durations that are too long.
constexpr double kFirstSlack = 1.5;

/// Segments that a straight flight needs to come near the trapezoid's duration: two to gain speed, one to hold it, two
/// to lose it. Each polyhedron gets a share of them, by its part of the way.
constexpr double kFlightSplit = kMaxSplit;
/// Further segments for each via that the flight passes without a stop.
constexpr double kViaSplit = 2.0;
/// The least number of segments of a polyhedron around a moving end. There are fewer if each would take less than
/// kEndPiece seconds at the end's speed. Such segments cannot get shorter, and the flight would have to brake to stay
/// in them.
constexpr int kEndSplit = 3;
constexpr double kEndPiece = 0.15;
/// A segment is at most this many times as long as the way to reach the limit speed and to stop again. But no
/// polyhedron is split into more than kRunSplit segments for that.
constexpr double kLongestRun = 2.5;
constexpr int kRunSplit = 3;
/// The least cosine of the angle between two pieces of one leg.
constexpr double kStraight = 1.0 - 1e-9;

/// The times of an earlier plan count at joints that it passes within this distance, metres.
constexpr double kBeside = 1.5;
/// The times of an earlier plan are multiplied by kPaceSlack, because they are a little short for a chain that differs,
/// and a programme without a solution costs most. The result is clamped between kLeastPaced of the segment's own first
/// duration and the whole of it. Otherwise an earlier plan that slows down to its end would be too slow for a chain
/// that goes on.
///
/// A plan that has to beat the earlier one begins a per cent faster than that. If such durations have no solution, the
/// new plan would hardly be better.
constexpr double kPaceSlack = 1.05;
constexpr double kRivalSlack = 0.99;
constexpr double kLeastPaced = 0.4;

constexpr JointState kAtRest{};

bool moves(const JointState& state) {
  return dot(state.d[1], state.d[1]) > 0.0 || dot(state.d[2], state.d[2]) > 0.0 || dot(state.d[3], state.d[3]) > 0.0;
}

double way(const Polyhedron& polyhedron) {
  return distance(polyhedron.from, polyhedron.to);
}

/// Metres that it takes to reach the speed limit, or the speed that the flight has room for if that is less, and to
/// stop again.
double comfortable_length(const TimesStage& stage, const Polyhedron& polyhedron) {
  const LineLimits line = limits_along(polyhedron.to - polyhedron.from, stage.limits);
  const double speed = smaller(line.speed, stage.speed);
  return speed * speed / line.acceleration;
}

int most(int a, int b) {
  return a < b ? b : a;
}

/// The way from stop to stop that a polyhedron is part of. Without stops it is the whole way.
struct Run {
  double length;    ///< metres
  double segments;  ///< that the way is split into, up to rounding
};

/// The polyhedron's share of the segments of its run, rounded.
int split_by_part(const Polyhedron& polyhedron, const Run& run) {
  const double part = run.segments * (way(polyhedron) / run.length);
  const int floor = static_cast<int>(part);
  return part - floor < 0.5 ? floor : floor + 1;
}

/// True if the way runs straight through the polyhedron and both of its neighbours: a piece of a long leg, along which
/// a flight cruises.
bool runs_straight(const Corridor& corridor, int index) {
  if (index == 0 || index + 1 == corridor.count) return false;
  const Vec3 before = corridor.polyhedra[index - 1].to - corridor.polyhedra[index - 1].from;
  const Vec3 along = corridor.polyhedra[index].to - corridor.polyhedra[index].from;
  const Vec3 after = corridor.polyhedra[index + 1].to - corridor.polyhedra[index + 1].from;
  return dot(before, along) >= kStraight * length(before) * length(along) &&
         dot(along, after) >= kStraight * length(along) * length(after);
}

int split_by_run(const TimesStage& stage, const Polyhedron& polyhedron) {
  const double runs = way(polyhedron) / (kLongestRun * comfortable_length(stage, polyhedron));
  return runs > 2.0 ? kRunSplit : (runs > 1.0 ? 2 : 1);
}

int split_at_end(const JointState& end, const Polyhedron& polyhedron) {
  if (!moves(end)) return 1;
  int split = kEndSplit;
  while (split > 1 && way(polyhedron) < split * kEndPiece * length(end.d[1])) --split;
  return split;
}

int split_of(const TimesStage& stage, const Chain& chain, const Corridor& corridor, int index, const Run* runs) {
  const Polyhedron& polyhedron = corridor.polyhedra[index];
  int least = 1;
  if (index == 0) least = split_at_end(chain.start, polyhedron);
  if (index + 1 == corridor.count) least = most(least, split_at_end(chain.goal, polyhedron));
  if (!(way(polyhedron) > 0.0)) return least;
  const int by_run = runs_straight(corridor, index) ? 1 : split_by_run(stage, polyhedron);
  return most(least, most(split_by_part(polyhedron, runs[index]), by_run));
}

/// The most segments that a polyhedron may be split into, so that all fit into kMaxSegments.
int fitting_split(const TimesStage& stage, const Chain& chain, const Corridor& corridor, const Run* runs) {
  for (int most = kMaxSplit; most > 1; --most) {
    int sum = 0;
    for (int i = 0; i < corridor.count; ++i) {
      const int split = split_of(stage, chain, corridor, i, runs);
      sum += split < most ? split : most;
    }
    if (sum <= kMaxSegments) return most;
  }
  return 1;
}

/// Finds the run of each polyhedron.
void measure_runs(const TimesStage& stage, const Chain& chain, const Corridor& corridor, Run* runs) {
  int begin = 0;
  for (int end = 1; end <= corridor.count; ++end) {
    if (end < corridor.count && !stage.after_stop[end]) continue;
    Run run{0.0, kFlightSplit};
    for (int i = begin; i < end; ++i) run.length += way(corridor.polyhedra[i]);
    for (int v = 0; v < chain.via_joint_count; ++v) {
      if (begin < chain.via_joints[v].polyhedron && chain.via_joints[v].polyhedron < end) run.segments += kViaSplit;
    }
    for (int i = begin; i < end; ++i) runs[i] = run;
    begin = end;
  }
}

/// Part of the speed that the flight loses at the beginning of segment `i` > 0.
double slowing_at(const TimesStage& stage, const Chain& chain, int i) {
  return chain.polyhedron[i] != chain.polyhedron[i - 1] ? stage.slowing[chain.polyhedron[i]] : 0.0;
}

/// Part of the speed that is lost at a turn of the way: 0 if the way goes straight on, 1 if it goes back.
double turn_at(const Corridor& corridor, int index) {
  const Vec3 before = corridor.polyhedra[index - 1].to - corridor.polyhedra[index - 1].from;
  const Vec3 after = corridor.polyhedra[index].to - corridor.polyhedra[index].from;
  const double lengths = length(before) * length(after);
  return lengths > 0.0 ? 0.5 * (1.0 - dot(before, after) / lengths) : 1.0;
}

/// Seconds by which a ramp to the cruising speed (or from it) at an end of the chain takes longer than cruising the
/// same way.
double ramp_time(const JointState& end, const LineLimits& line) {
  const double missing = larger(0.0, line.speed - length(end.d[1]));
  return missing * missing / (2.0 * line.speed * line.acceleration);
}

void take_via_joints(TimesStage& stage, const ViaJoints& via_joints, const Corridor& corridor, Chain& chain) {
  chain.via_joint_count = via_joints.count;
  for (int i = 0; i < corridor.count; ++i) {
    stage.after_stop[i] = false;
    stage.slowing[i] = 0.0;
  }
  for (int i = 0; i < via_joints.count; ++i) {
    const ViaJoint& via_joint = via_joints.list[i];
    chain.via_joints[i] = via_joint;
    stage.after_stop[via_joint.polyhedron] = via_joint.stop;
    stage.slowing[via_joint.polyhedron] = via_joint.stop ? 1.0 : turn_at(corridor, via_joint.polyhedron);
  }
}

/// The segment's own first duration: cruising along its way, with the trapezoid's ramps at the chain's ends, and at
/// vias that it slows down for.
double time_of(const TimesStage& stage, const Chain& chain, const Corridor& corridor, int i) {
  const MotionLimits& limits = stage.limits;
  const Polyhedron& polyhedron = corridor.polyhedra[chain.polyhedron[i]];
  double time = 0.0;
  if (chain.length[i] > 0.0) {
    LineLimits line = limits_along(polyhedron.to - polyhedron.from, limits);
    line.speed = smaller(line.speed, stage.speed);
    line.acceleration = ramp_acceleration(polyhedron.to - polyhedron.from, limits, line);
    time = chain.length[i] / line.speed;
    if (i == 0) time += ramp_time(chain.start, line);
    if (i > 0) time += slowing_at(stage, chain, i) * ramp_time(kAtRest, line);
    if (i + 1 == chain.count) time += ramp_time(chain.goal, line);
    if (i + 1 < chain.count) time += slowing_at(stage, chain, i + 1) * ramp_time(kAtRest, line);
    time = smaller(time, trapezoid_time(chain.length[i], line));
  }
  return larger(kMinDuration, kFirstSlack * time);
}

void begin_pace(TimesStage& stage, const Pace& pace) {
  stage.pace = pace;
  stage.along = 0.0;
  stage.beside = pace.plan != nullptr;
  stage.paced = false;
  if (stage.beside) pace_begin(pace, stage.walk);
}

/// The point at which the way of the segment ends.
Vec3 next_joint(TimesStage& stage, const Chain& chain, const Corridor& corridor, int i) {
  const Polyhedron& polyhedron = corridor.polyhedra[chain.polyhedron[i]];
  const bool is_last = i + 1 == chain.count || chain.polyhedron[i + 1] != chain.polyhedron[i];
  stage.along = is_last ? 0.0 : stage.along + chain.length[i];
  if (is_last) return polyhedron.to;
  // A way of length 0 has several segments only at an end with an acceleration but no velocity. The joint is then NaN,
  // which counts as not beside the earlier plan.
  return polyhedron.from + (stage.along / way(polyhedron)) * (polyhedron.to - polyhedron.from);
}

/// The time that the earlier plan takes for the segment if it passes both ends nearby; else the segment's own.
double paced_time(TimesStage& stage, const Chain& chain, const Corridor& corridor, int i, Work& work) {
  const double own = time_of(stage, chain, corridor, i);
  if (stage.pace.plan == nullptr) return own;
  const double begin = stage.walk.time;
  const bool begins_beside = stage.beside;
  int pieces = 0;
  stage.beside = pace_to(stage.pace, next_joint(stage, chain, corridor, i), stage.walk, pieces) < kBeside;
  work.spend(ops::kCurve * pieces);
  if (!begins_beside || !stage.beside) return own;
  stage.paced = true;
  const double slack = stage.pace.is_rival ? kRivalSlack : kPaceSlack;
  return larger(kMinDuration, clamp(slack * (stage.walk.time - begin), kLeastPaced * own, own));
}

}  // namespace

void times_begin(TimesStage& stage, const Corridor& corridor, const TimesQuery& query, Chain& chain) noexcept {
  chain.count = 0;
  chain.start = JointState{{query.start.position, query.start.velocity, query.start.acceleration, query.start.jerk}};
  chain.goal = JointState{{query.goal.position, query.goal.velocity, query.goal.acceleration, query.goal.jerk}};
  chain.center = 0.5 * (query.start.position + query.goal.position);
  stage.limits = query.limits;
  stage.speed = reachable(chain, corridor, query.limits).speed;
  take_via_joints(stage, query.via_joints, corridor, chain);
  Run runs[kMaxSegments];
  measure_runs(stage, chain, corridor, runs);
  const int most = fitting_split(stage, chain, corridor, runs);
  for (int i = 0; i < corridor.count; ++i) {
    const int wanted = split_of(stage, chain, corridor, i, runs);
    const int pieces = wanted < most ? wanted : most;
    append_pieces(way(corridor.polyhedra[i]) / pieces, i, pieces, chain);
  }
  place_via_joints(chain);
  stage.timed = 0;
  begin_pace(stage, query.pace);
}

Progress times_advance(TimesStage& stage, const Corridor& corridor, Work& work, Chain& chain) noexcept {
  for (; stage.timed < chain.count; ++stage.timed) {
    if (!work.left()) return Progress::kMore;
    work.spend(ops::kCurve + ops::kPiece);
    chain.duration[stage.timed] = paced_time(stage, chain, corridor, stage.timed, work);
  }
  return Progress::kDone;
}

}  // namespace tern
