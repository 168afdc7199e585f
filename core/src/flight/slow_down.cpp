// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/capacity.hpp"
#include "base/math.hpp"
#include "flight/branch.hpp"

namespace tern {
namespace {

/// The largest first derivative of the pace times the duration, and the largest second derivative times its square.
constexpr double kSteepestBlend = 1.875;
constexpr double kMostCurved = 5.7735026918962576;
/// Each slow-down takes this many times as long as the one before it; and the shortest duration, seconds.
constexpr double kSlower = 1.3;
constexpr double kShortest = 0.2;
/// The wanted length of a slow-down's segments, seconds, and the least and the largest number of them, without those
/// that the plan's joints add. Their error falls with the eighth power of their length.
constexpr double kSlowPiece = 0.06;
constexpr double kLeastPieces = 10.0;
constexpr double kMostPieces = 24.0;
/// If the plan's next joint is nearer than this, seconds, no segment ends there. In so short a segment, the rounding of
/// the jerk would harm the path more than the joint's jump in snap does.
constexpr double kLeastPiece = 1e-4;
constexpr int kHalvings = 50;
constexpr double kNoJoint = 1e300;

/// How the time along the plan passes: at the usual pace first, and not at all in the end. The pace is 1 - (10 u^3 -
/// 15 u^4 + 6 u^5), whose first two derivatives are 0 at both ends.
struct Pace {
  double from;
  double time;

  /// Time along the plan after t seconds, and its derivatives.
  double at(double t) const {
    const double u = t / time;
    return from + time * (u - u * u * u * u * (2.5 - 3.0 * u + u * u));
  }
  double first(double t) const {
    const double u = t / time;
    return 1.0 - u * u * u * (10.0 - 15.0 * u + 6.0 * u * u);
  }
  double second(double t) const {
    const double u = t / time;
    return -30.0 * u * u * (1.0 - u) * (1.0 - u) / time;
  }
  double third(double t) const {
    const double u = t / time;
    return -60.0 * u * (1.0 - u) * (1.0 - 2.0 * u) / (time * time);
  }
  /// Seconds after which the time along the plan is `planned`.
  double time_at(double planned) const {
    double low = 0.0;
    double high = time;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (low + high);
      (at(middle) < planned ? low : high) = middle;
    }
    return high;
  }
};

/// Position to jerk at `t`. The position is relative to the plan's origin, so it is free of the rounding of world
/// coordinates.
JointState local_state(const Trajectory& plan, double t) {
  double begin = 0.0;
  int index = 0;
  while (index + 1 < plan.count && t >= begin + plan.segments[index].duration) {
    begin += plan.segments[index++].duration;
  }
  const Segment& segment = plan.segments[index];
  return state_at(segment, clamp((t - begin) / segment.duration, 0.0, 1.0));
}

/// The state after `t` seconds of the slow-down: the chain rule, to the third derivative.
JointState paced(const Trajectory& plan, const Pace& pace, double t, const Vec3& shift) {
  JointState s = local_state(plan, pace.at(t));
  s.d[0] = s.d[0] + shift;
  if (t >= pace.time) return JointState{{s.d[0], kZero, kZero, kZero}};
  const double r1 = pace.first(t);
  const double r2 = pace.second(t);
  const double r3 = pace.third(t);
  return JointState{{s.d[0], r1 * s.d[1], (r1 * r1) * s.d[2] + r2 * s.d[1],
                     (r1 * r1 * r1) * s.d[3] + (3.0 * r1 * r2) * s.d[2] + r3 * s.d[1]}};
}

/// The time of the plan's first joint after `planned`; the plan's end counts as one.
double joint_after(const Trajectory& plan, double planned) {
  double joint = 0.0;
  for (int i = 0; i < plan.count && joint <= planned; ++i) joint += plan.segments[i].duration;
  return joint > planned ? joint : kNoJoint;
}

}  // namespace

double slow_down_time(const Vec3& velocity, const MotionLimits& limits, int way) noexcept {
  const Vec3 back = -1.0 * velocity;
  double time = larger(kShortest, kSteepestBlend * gauge(limits.acceleration, back));
  time = larger(time, square_root(kMostCurved * ramp_gauge(limits, back)));
  for (int i = 0; i < way; ++i) time *= kSlower;
  return time;
}

bool append_slow_down(const Trajectory& plan, double from, double time, Trajectory& out) noexcept {
  const Pace pace{from, time};
  const double step = time / clamp(time / kSlowPiece, kLeastPieces, kMostPieces);
  const Vec3 shift = plan.origin - out.origin;
  JointState state = paced(plan, pace, 0.0, shift);
  double t = 0.0;
  while (out.count < kMaxSegments) {
    const bool is_last = t + 1.25 * step >= time;
    double next = is_last ? time : t + step;
    const double joint = joint_after(plan, pace.at(t + kLeastPiece));
    const bool ends_at_joint = pace.at(next + 0.25 * step) > joint;
    if (ends_at_joint) next = pace.time_at(joint);
    const JointState to = paced(plan, pace, next, shift);
    if (is_full(!append_between(state, to, next - t, out))) return false;
    if (is_last && !ends_at_joint) return true;
    state = to;
    t = next;
  }
  return false;
}

}  // namespace tern
