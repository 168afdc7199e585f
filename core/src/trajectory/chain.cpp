// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/chain.hpp"

#include "base/bounds.hpp"
#include "curve/motion_limits.hpp"
#include "times/times.hpp"
#include "trajectory/hodograph_rows.hpp"

namespace tern {
namespace {

constexpr Vec3 kZero{0.0, 0.0, 0.0};

/// First durations over those of the trapezoid: a curve of degree 7 needs a higher peak for the same way. To begin
/// below what is feasible costs more than to begin above.
constexpr double kFirstSlack = 1.5;
/// What a segment beside a moving end takes at least, in times that braking takes.
constexpr double kEndPart = 0.4;

/// A segment's way at most: this part of the whole way, and this many times the way to the limit speed and back.
constexpr double kLongestPart = 0.5;
constexpr double kLongestRun = 2.5;

/// Lengths are looked at in this many steps of kEndStep before an end's duration is given up: a factor of 1e5.
constexpr int kEndTries = 52;
constexpr double kEndStep = 0.8;

bool moves(const JointState& state) {
  return dot(state.d[1], state.d[1]) > 0.0 || dot(state.d[2], state.d[2]) > 0.0;
}

double way(const Polyhedron& polyhedron) {
  return distance(polyhedron.from, polyhedron.to);
}

/// Metres that it takes to reach the limit speed and stop again.
double comfortable_length(const Polyhedron& polyhedron, const Limits& limits) {
  const LineLimits line = limits_along(polyhedron.to - polyhedron.from, limits);
  return line.speed * line.speed / line.acceleration;
}

int split_of(const Chain& chain, const Corridor& corridor, const Limits& limits, int index, double whole) {
  const Polyhedron& polyhedron = corridor.polyhedra[index];
  const double length = way(polyhedron);
  const bool at_moving_end = (index == 0 && moves(chain.start)) || (index + 1 == corridor.count && moves(chain.goal));
  if (at_moving_end) return kMaxSplit;
  if (!(length > 0.0)) return 1;
  const double piece = smaller(kLongestPart * whole, kLongestRun * comfortable_length(polyhedron, limits));
  // A little less than the quotient, so that halves stay halves.
  const double pieces = length / piece - 1e-6;
  return pieces > 2.0 ? kMaxSplit : (pieces > 1.0 ? 2 : 1);
}

/// The most that each polyhedron may be split for the sum to fit.
int fitting_split(const Chain& chain, const Corridor& corridor, const Limits& limits, double whole) {
  for (int most = kMaxSplit; most > 1; --most) {
    int sum = 0;
    for (int i = 0; i < corridor.count; ++i) {
      const int split = split_of(chain, corridor, limits, i, whole);
      sum += split < most ? split : most;
    }
    if (sum <= kMaxSegments) return most;
  }
  return 1;
}

/// `length`: of each piece.
void append_pieces(double length, int polyhedron, int pieces, Chain& chain) {
  for (int i = 0; i < pieces; ++i) {
    chain.polyhedron[chain.count] = polyhedron;
    chain.length[chain.count] = length;
    ++chain.count;
  }
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

/// Cruising through the chain along its way, with the trapezoid's ramps at its ends only.
void allocate(const Corridor& corridor, const Limits& limits, Chain& chain) {
  const Bounds acceleration = acceleration_bounds(limits);
  for (int i = 0; i < chain.count; ++i) {
    const Polyhedron& polyhedron = corridor.polyhedra[chain.polyhedron[i]];
    double time = 0.0;
    if (chain.length[i] > 0.0) {
      const LineLimits line = limits_along(polyhedron.to - polyhedron.from, limits);
      time = chain.length[i] / line.speed;
      if (i == 0) time += ramp_time(chain.start, line);
      if (i + 1 == chain.count) time += ramp_time(chain.goal, line);
      time = smaller(time, trapezoid_time(chain.length[i], line));
    }
    time = larger(time, least_end_time(chain, acceleration, i));
    chain.duration[i] = larger(kMinDuration, kFirstSlack * time);
  }
}

/// True where the rows that depend on the first four control points only keep the limit.
bool fixed_rows_hold(const double (*rows)[kControlPoints], int count, const Vec3* points, double scale,
                     const Bounds& bounds) {
  for (int r = 0; r < count; ++r) {
    Vec3 value = kZero;
    bool fixed = true;
    for (int k = 0; k < kControlPoints; ++k) {
      if (k < kJointOrder) value = value + (scale * rows[r][k]) * (points[k] - points[0]);
      if (k >= kJointOrder && (rows[r][k] < 0.0 || rows[r][k] > 0.0)) fixed = false;
    }
    if (fixed && gauge(bounds, value) > 1.0 + kLimitTolerance) return false;
  }
  return true;
}

bool end_holds(const JointState& end, const Polyhedron& polyhedron, const Limits& limits, double duration) {
  Segment segment{};
  control_points(end, end, duration, segment.points);
  for (int k = kJointOrder; k <= kDegree; ++k) segment.points[k] = end.d[0];
  const double rate = 1.0 / duration;
  return inside(segment, polyhedron) &&
         fixed_rows_hold(kHodographRows.velocity, kVelocityRows, segment.points, rate, velocity_bounds(limits)) &&
         fixed_rows_hold(kHodographRows.acceleration, kAccelerationRows, segment.points, rate * rate,
                         acceleration_bounds(limits));
}

double fitting_duration(const JointState& end, const Polyhedron& polyhedron, const Limits& limits, double duration) {
  if (!moves(end)) return duration;
  for (int i = 0; i < kEndTries && duration > kMinDuration; ++i) {
    if (end_holds(end, polyhedron, limits, duration)) return duration;
    duration *= kEndStep;
  }
  return larger(duration, kMinDuration);
}

bool goes_from_rest_to_rest(const Segment& segment) {
  for (int k = 1; k < kJointOrder; ++k) {
    if (distance(segment.points[0], segment.points[k]) > 0.0) return false;
    if (distance(segment.points[kDegree], segment.points[kDegree - k]) > 0.0) return false;
  }
  return true;
}

/// The same state flown backwards in time.
JointState backwards(const JointState& state) {
  return JointState{{state.d[0], kZero - state.d[1], state.d[2], kZero - state.d[3]}};
}

}  // namespace

void make_chain(const Corridor& corridor, const State& start, const State& goal, const Limits& limits,
                Chain& chain) noexcept {
  chain.count = 0;
  chain.start = JointState{{start.position, start.velocity, start.acceleration, kZero}};
  chain.goal = JointState{{goal.position, goal.velocity, goal.acceleration, kZero}};
  chain.center = 0.5 * (start.position + goal.position);
  double length = 0.0;
  for (int i = 0; i < corridor.count; ++i) length += way(corridor.polyhedra[i]);
  const int most = fitting_split(chain, corridor, limits, length);
  for (int i = 0; i < corridor.count; ++i) {
    const int wanted = split_of(chain, corridor, limits, i, length);
    const int pieces = wanted < most ? wanted : most;
    append_pieces(way(corridor.polyhedra[i]) / pieces, i, pieces, chain);
  }
  allocate(corridor, limits, chain);
}

void fit_ends(const Corridor& corridor, const Limits& limits, Chain& chain) noexcept {
  const int last = chain.count - 1;
  chain.duration[0] = fitting_duration(chain.start, corridor.polyhedra[0], limits, chain.duration[0]);
  chain.duration[last] = fitting_duration(backwards(chain.goal), corridor.polyhedra[corridor.count - 1],
                                          backwards(limits), chain.duration[last]);
}

void follow(const Trajectory& plan, Chain& chain) noexcept {
  const int most = 2 * plan.count <= kMaxSegments ? 2 : 1;
  chain.count = 0;
  for (int i = 0; i < plan.count; ++i) {
    const Segment& segment = plan.segments[i];
    const int pieces = goes_from_rest_to_rest(segment) ? most : 1;
    const double length = distance(segment.points[0], segment.points[kDegree]) / pieces;
    append_pieces(length, segment.polyhedron, pieces, chain);
    for (int k = 1; k <= pieces; ++k) chain.duration[chain.count - k] = larger(kMinDuration, segment.duration / pieces);
  }
}

double chain_duration(const Chain& chain) noexcept {
  double sum = 0.0;
  for (int i = 0; i < chain.count; ++i) sum += chain.duration[i];
  return sum;
}

}  // namespace tern
