// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/chain.hpp"

#include "base/bounds.hpp"
#include "times/times.hpp"
#include "trajectory/hodograph_rows.hpp"
#include "trajectory/motion_limits.hpp"

namespace tern {
namespace {

constexpr Vec3 kZero{0.0, 0.0, 0.0};

/// Lengths are looked at in this many steps of kEndStep before an end's duration is given up: a factor of 1e5.
constexpr int kEndTries = 52;
constexpr double kEndStep = 0.8;

/// Durations of the first two segments beside a moving end, in times that braking from its speed takes, and the part of
/// the limit speed that counts as its speed at least.
constexpr double kOuterPart = 0.4;
constexpr double kInnerPart = 0.8;
constexpr double kLeastEndSpeed = 0.25;

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

int split_of(const Chain& chain, const Corridor& corridor, const Limits& limits, int index, double third) {
  const Polyhedron& polyhedron = corridor.polyhedra[index];
  const double length = way(polyhedron);
  const bool at_moving_end = (index == 0 && moves(chain.start)) || (index + 1 == corridor.count && moves(chain.goal));
  if (at_moving_end) return kMaxSplit;
  if (!(length > 0.0)) return 1;
  const double piece = smaller(third, comfortable_length(polyhedron, limits));
  // A little less than the quotient, so that thirds stay thirds.
  const double pieces = length / piece - 1e-6;
  return pieces > 2.0 ? kMaxSplit : (pieces > 1.0 ? 2 : 1);
}

/// Seconds that it takes to lose the speed of an end, or a part of the limit speed.
double braking_time(const JointState& end, const Limits& limits) {
  double time = gauge(acceleration_bounds(limits), kZero - end.d[1]);
  for (int a = 0; a < 3; ++a) {
    time = larger(time, kLeastEndSpeed * axis(limits.v_max, a) / axis(limits.a_max, a));
  }
  return time;
}

/// The most that each polyhedron may be split for the sum to fit.
int fitting_split(const Chain& chain, const Corridor& corridor, const Limits& limits, double third) {
  for (int most = kMaxSplit; most > 1; --most) {
    int sum = 0;
    for (int i = 0; i < corridor.count; ++i) {
      const int split = split_of(chain, corridor, limits, i, third);
      sum += split < most ? split : most;
    }
    if (sum <= kMaxSegments) return most;
  }
  return 1;
}

void append_pieces(const Polyhedron& polyhedron, int index, int pieces, const Limits& limits, Chain& chain) {
  const double length = way(polyhedron) / pieces;
  const double time =
      length > 0.0 ? trapezoid_time(length, limits_along(polyhedron.to - polyhedron.from, limits)) : kMinDuration;
  for (int i = 0; i < pieces; ++i) {
    chain.polyhedron[chain.count] = index;
    chain.duration[chain.count] = time;
    ++chain.count;
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

/// The same state flown backwards in time.
JointState backwards(const JointState& state) {
  return JointState{{state.d[0], kZero - state.d[1], state.d[2], kZero - state.d[3]}};
}

/// Next to a moving end two short segments: its acceleration must come and go before the way matters.
void shorten_moving_ends(const Limits& limits, Chain& chain) {
  const int last = chain.count - 1;
  if (last == 0) return;
  const JointState* const ends[2] = {&chain.start, &chain.goal};
  for (int side = 0; side < 2; ++side) {
    if (!moves(*ends[side])) continue;
    const double braking = braking_time(*ends[side], limits);
    double& outer = chain.duration[side == 0 ? 0 : last];
    double& inner = chain.duration[side == 0 ? 1 : last - 1];
    outer = larger(kMinDuration, kOuterPart * braking);
    if (last > 2) inner = smaller(inner, larger(kMinDuration, kInnerPart * braking));
  }
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
  const double third = length / 3.0;
  const int most = fitting_split(chain, corridor, limits, third);
  for (int i = 0; i < corridor.count; ++i) {
    const int split = split_of(chain, corridor, limits, i, third);
    append_pieces(corridor.polyhedra[i], i, split < most ? split : most, limits, chain);
  }
  shorten_moving_ends(limits, chain);
}

void fit_ends(const Corridor& corridor, const Limits& limits, Chain& chain) noexcept {
  const int last = chain.count - 1;
  chain.duration[0] = fitting_duration(chain.start, corridor.polyhedra[0], limits, chain.duration[0]);
  chain.duration[last] = fitting_duration(backwards(chain.goal), corridor.polyhedra[corridor.count - 1],
                                          backwards(limits), chain.duration[last]);
}

double chain_duration(const Chain& chain) noexcept {
  double sum = 0.0;
  for (int i = 0; i < chain.count; ++i) sum += chain.duration[i];
  return sum;
}

}  // namespace tern
