// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "times/times_stage.hpp"

#include "base/bounds.hpp"
#include "times/time_unit.hpp"
#include "times/trapezoid.hpp"

namespace tern {
namespace {

/// First durations over those of the trapezoid: a curve of degree 7 needs a higher peak for the same way. To begin
/// below what is feasible costs more than to begin above.
constexpr double kFirstSlack = 1.5;
/// What a segment beside a moving end takes at least, in times that braking takes.
constexpr double kEndPart = 0.4;

/// A segment's way at most: this part of the whole way, and this many times the way to the limit speed and back.
constexpr double kLongestPart = 0.5;
constexpr double kLongestRun = 2.5;

bool moves(const JointState& state) {
  return dot(state.d[1], state.d[1]) > 0.0 || dot(state.d[2], state.d[2]) > 0.0 || dot(state.d[3], state.d[3]) > 0.0;
}

double way(const Polyhedron& polyhedron) {
  return distance(polyhedron.from, polyhedron.to);
}

/// Metres that it takes to reach the speed limit, or what the flight has room for, and to stop again.
double comfortable_length(const TimesStage& stage, const Polyhedron& polyhedron) {
  const LineLimits line = limits_along(polyhedron.to - polyhedron.from, stage.limits);
  const double speed = smaller(line.speed, stage.speed);
  return speed * speed / line.acceleration;
}

int split_of(const TimesStage& stage, const Chain& chain, const Corridor& corridor, int index, double whole) {
  const Polyhedron& polyhedron = corridor.polyhedra[index];
  const double length = way(polyhedron);
  const bool at_moving_end = (index == 0 && moves(chain.start)) || (index + 1 == corridor.count && moves(chain.goal));
  if (at_moving_end) return kMaxSplit;
  if (!(length > 0.0)) return 1;
  if (corridor.count == 1) return kMaxSplit;
  const double piece = smaller(kLongestPart * whole, kLongestRun * comfortable_length(stage, polyhedron));
  // A little less than the quotient, so that halves stay halves.
  const double pieces = length / piece - 1e-6;
  return pieces > 2.0 ? kMaxSplit : (pieces > 1.0 ? 2 : 1);
}

/// The most that each polyhedron may be split for the sum to fit.
int fitting_split(const TimesStage& stage, const Chain& chain, const Corridor& corridor, double whole) {
  for (int most = kMaxSplit; most > 1; --most) {
    int sum = 0;
    for (int i = 0; i < corridor.count; ++i) {
      const int split = split_of(stage, chain, corridor, i, whole);
      sum += split < most ? split : most;
    }
    if (sum <= kMaxSegments) return most;
  }
  return 1;
}

/// Seconds that gaining (or losing) the cruising speed at an end of the chain takes beyond cruising the same way.
double ramp_time(const JointState& end, const LineLimits& line) {
  const double missing = larger(0.0, line.speed - length(end.d[1]));
  return missing * missing / (2.0 * line.speed * line.acceleration);
}

/// Seconds that a segment of the polyhedron around a moving end takes at least: a part of braking.
double least_end_time(const Chain& chain, const Bounds& acceleration, int i) {
  double time = 0.0;
  if (chain.polyhedron[i] == 0) time = gauge(acceleration, kZero - chain.start.d[1]);
  if (chain.polyhedron[i] == chain.polyhedron[chain.count - 1]) {
    time = larger(time, gauge(acceleration, chain.goal.d[1]));
  }
  return kEndPart * time;
}

/// Cruising along the segment's way, with the trapezoid's ramps at the chain's ends only.
double time_of(const TimesStage& stage, const Chain& chain, const Corridor& corridor, int i) {
  const MotionLimits& limits = stage.limits;
  const Polyhedron& polyhedron = corridor.polyhedra[chain.polyhedron[i]];
  double time = 0.0;
  if (chain.length[i] > 0.0) {
    LineLimits line = limits_along(polyhedron.to - polyhedron.from, limits);
    line.speed = smaller(line.speed, stage.speed);
    time = chain.length[i] / line.speed;
    if (i == 0) time += ramp_time(chain.start, line);
    if (i + 1 == chain.count) time += ramp_time(chain.goal, line);
    time = smaller(time, trapezoid_time(chain.length[i], line));
  }
  time = larger(time, least_end_time(chain, limits.acceleration, i));
  return larger(kMinDuration, kFirstSlack * time);
}

}  // namespace

void times_begin(TimesStage& stage, const Corridor& corridor, const TimesQuery& query, Chain& chain) noexcept {
  chain.count = 0;
  chain.start = JointState{{query.start.position, query.start.velocity, query.start.acceleration, query.start.jerk}};
  chain.goal = JointState{{query.goal.position, query.goal.velocity, query.goal.acceleration, query.goal.jerk}};
  chain.center = 0.5 * (query.start.position + query.goal.position);
  stage.limits = query.limits;
  stage.speed = reachable(chain, corridor, query.limits).speed;
  double length = 0.0;
  for (int i = 0; i < corridor.count; ++i) length += way(corridor.polyhedra[i]);
  const int most = fitting_split(stage, chain, corridor, length);
  for (int i = 0; i < corridor.count; ++i) {
    const int wanted = split_of(stage, chain, corridor, i, length);
    const int pieces = wanted < most ? wanted : most;
    append_pieces(way(corridor.polyhedra[i]) / pieces, i, pieces, chain);
  }
  stage.timed = 0;
}

Progress times_advance(TimesStage& stage, const Corridor& corridor, Work& work, Chain& chain) noexcept {
  for (; stage.timed < chain.count; ++stage.timed) {
    if (!work.take()) return Progress::kMore;
    chain.duration[stage.timed] = time_of(stage, chain, corridor, stage.timed);
  }
  return Progress::kDone;
}

}  // namespace tern
