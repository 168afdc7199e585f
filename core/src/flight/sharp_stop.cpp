// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "curve/brake.hpp"
#include "curve/motion_limits.hpp"
#include "flight/branch.hpp"

namespace tern {
namespace {

/// Halvings of the range in which the shortest ramp is sought. They leave less than a millionth of it.
constexpr int kRampHalvings = 20;
constexpr double kLeastJerk = 1e-6;  ///< m/s^3
constexpr double kEndless = 1e300;

/// How the acceleration changes along a ramp: the largest slope of its course, which rises from 0 to 1, and the second
/// integral of that, with which the acceleration at the ramp's end counts for the way.
struct Course {
  double peak;
  double way;
};

/// The smooth step 3 u^2 - 2 u^3.
constexpr Course kSmooth{kSmoothStepPeak, 0.15};
/// The flattest of degree 5 that begins and ends with no slope. Its slope is 9/8 (1 - w^2) (1 + 5/3 w^2), w = 2 u - 1.
constexpr Course kFlat{1.2, 11.0 / 70.0};

/// A ramp, a steady part that may be missing, and another ramp.
struct Ramps {
  double ramp;
  double steady;
  Vec3 deceleration;
};

/// The brake with ramps of this length, seconds. The first ramp undoes the acceleration. The deceleration, over one
/// ramp and the steady part, takes the speed that is left then.
Ramps ramps_of(const JointState& from, const MotionLimits& limits, double ramp) {
  const Vec3 excess = from.d[1] + (0.5 * ramp) * from.d[2];
  const double needed = gauge(limits.acceleration, kZero - excess) - ramp;
  const double steady = needed > 0.0 ? larger(needed, kMinDuration) : 0.0;
  return {ramp, steady, (-1.0 / (ramp + steady)) * excess};
}

/// The jerk of a ramp is at most the course's peak times the change of acceleration over its length.
bool keeps_jerk(const JointState& from, const MotionLimits& limits, const Course& course, const Ramps& ramps) {
  const double first = ramp_gauge(limits, ramps.deceleration - from.d[2]);
  const double second = ramp_gauge(limits, ramps.deceleration);
  return course.peak * larger(first, second) <= (1.0 - kJerkMargin) * ramps.ramp;
}

/// Finds the shortest ramps by bisection. The longest ones lose all the speed at the limit of jerk, without a steady
/// part.
Ramps shortest_ramps(const JointState& from, const MotionLimits& limits, const Course& course) {
  Ramps best = ramps_of(from, limits, kMinDuration);
  if (keeps_jerk(from, limits, course, best)) return best;
  double low = kMinDuration;
  double high = kMinDuration +
                2.0 * kSmoothStepPeak * (square_root(ramp_gauge(limits, from.d[1])) + ramp_gauge(limits, from.d[2]));
  best = ramps_of(from, limits, high);
  for (int i = 0; i < kRampHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    const Ramps ramps = ramps_of(from, limits, middle);
    const bool keeps = keeps_jerk(from, limits, course, ramps);
    (keeps ? high : low) = middle;
    if (keeps) best = ramps;
  }
  return best;
}

/// The state at the end of a ramp that begins without jerk.
JointState after(const JointState& from, const Vec3& acceleration, double time, const Course& course) {
  JointState to = after_ramp(from, acceleration, time);
  to.d[0] = to.d[0] + ((course.way - kSmooth.way) * time * time) * (acceleration - from.d[2]);
  return to;
}

bool append_ramps(const JointState& from, const Ramps& ramps, const Course& course, Trajectory& out) {
  const JointState second = after(from, ramps.deceleration, ramps.ramp, course);
  const bool is_steady = ramps.steady > 0.0;
  const JointState last = is_steady ? after_ramp(second, ramps.deceleration, ramps.steady) : second;
  JointState rest = after(last, kZero, ramps.ramp, course);
  rest.d[1] = kZero;
  return append_between(from, second, ramps.ramp, out) &&
         (!is_steady || append_between(second, last, ramps.steady, out)) && append_between(last, rest, ramps.ramp, out);
}

bool keeps_limits(const Trajectory& plan, int first, const MotionLimits& limits) {
  for (int i = first; i < plan.count; ++i) {
    if (!within_limits(plan.segments[i], limits, kStopTolerance)) return false;
  }
  return true;
}

/// Appends a brake that takes the jerk to zero in `time` seconds first; 0 if the jerk is zero. False, and nothing is
/// appended, if there is no room or the limits do not hold.
bool append_settled(const JointState& from, const MotionLimits& limits, double time, const Course& course,
                    Trajectory& out) {
  const int count = out.count;
  const JointState calm = time > 0.0 ? settled(from, time) : from;
  const bool begins = !(time > 0.0) || append_between(from, calm, time, out);
  if (begins && append_ramps(calm, shortest_ramps(calm, limits, course), course, out) &&
      keeps_limits(out, count, limits))
    return true;
  out.count = count;
  return false;
}

bool append_shortest(const JointState& from, const MotionLimits& limits, const Course& course, Trajectory& out) {
  if (!(length(from.d[3]) > kLeastJerk)) return append_settled(from, limits, 0.0, course, out);
  double best = 0.0;
  double least = kEndless;
  double time = kSettleTime;
  const int count = out.count;
  for (int i = 0; i <= kSettleHalvings; ++i, time *= 0.5) {
    if (append_settled(from, limits, time, course, out)) {
      const double way = distance(from.d[0], out.segments[out.count - 1].points[kDegree]);
      if (way < least) {
        least = way;
        best = time;
      }
    }
    out.count = count;
  }
  return best > 0.0 && append_settled(from, limits, best, course, out);
}

}  // namespace

bool append_sharp_stop(const JointState& from, const MotionLimits& limits, Trajectory& out) noexcept {
  return append_shortest(from, limits, kSmooth, out);
}

bool append_flat_stop(const JointState& from, const MotionLimits& limits, Trajectory& out) noexcept {
  return append_shortest(from, limits, kFlat, out);
}

}  // namespace tern
