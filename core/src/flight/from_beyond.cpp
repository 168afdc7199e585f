// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern/from_beyond.hpp"

#include "base/bounds.hpp"
#include "base/math.hpp"
#include "curve/brake.hpp"
#include "flight/branch.hpp"
#include "flight/evasion.hpp"
#include "planner/validate.hpp"

namespace tern {
namespace {

/// No direction is weaker than this share of the weakest of the 26 that are looked at: gauges are convex, and each
/// direction lies between three of the 26, whose plane is 1 / sqrt(1.2726) from the centre.
constexpr double kBetweenDirections = 0.8864;
constexpr int kHalvings = 30;
/// Accelerations forwards from which brakes are looked at, besides none.
constexpr int kAccelerations = 8;
constexpr double kLeastShare = 0.01;

/// The gauge of a unit vector is largest in this direction of those to the sides, edges and corners of a cube.
double largest_gauge(const Bounds& bounds) {
  double most = 0.0;
  for (int n = 0; n < 27; ++n) {
    const int sides[3] = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
    const Vec3 way{1.0 * sides[0], 1.0 * sides[1], 1.0 * sides[2]};
    const double far = length(way);
    if (far > 0.0) most = larger(most, gauge(bounds, (1.0 / far) * way));
  }
  return most;
}

/// The largest speed in any direction.
double top_speed(const Limits& limits) {
  Vec3 most;
  for (int a = 0; a < 3; ++a) axis(most, a) = larger(axis(limits.v_max, a), -axis(limits.v_min, a));
  const double level = horizontal_length(most);
  const bool is_limited = limits.v_horizontal > 0.0 && limits.v_horizontal < level;
  const double across = is_limited ? limits.v_horizontal : level;
  return square_root(across * across + most.z * most.z);
}

/// The limits of the weakest direction, in all directions, without one on speed.
Limits weakest_of(const Limits& limits) {
  const MotionLimits motion(limits);
  const double acceleration = kBetweenDirections / largest_gauge(motion.acceleration);
  const double gauge_of_jerk = largest_gauge(motion.jerk);
  const double jerk = gauge_of_jerk > 0.0 ? kBetweenDirections / gauge_of_jerk : 0.0;
  Limits weakest{{kMaxLimit, kMaxLimit, kMaxLimit}, {acceleration, acceleration, acceleration}};
  weakest.j_max = {jerk, jerk, jerk};
  return weakest;
}

/// What comes, and how the vehicle brakes for it.
struct Approach {
  const FromBeyond& what;
  Limits weakest;
  double lead, clearance;  ///< s, m
  Trajectory& brake;       ///< memory for the one that is looked at
};

/// How far away a thing must be when it comes into range, if the vehicle has this speed and acceleration, m.
double needed_range(const Approach& approach, const MotionLimits& limits, double speed, double acceleration) {
  const FromBeyond& what = approach.what;
  Trajectory& brake = approach.brake;
  brake.count = 0;
  brake.origin = kZero;
  const JointState now{{kZero, {speed, 0.0, 0.0}, {acceleration, 0.0, 0.0}, kZero}};
  if (!append_sharp_stop(now, limits, brake)) return kAnywhere;
  const double time = what.delay + approach.lead + kSettleTime;
  const double way = brake.segments[brake.count - 1].points[kDegree].x;
  return approach.clearance + what.size + what.speed * (time + duration(brake)) + speed * time + way;
}

/// The same for all accelerations that a vehicle below `top` m/s may have: those that it can still end in time.
double needed_below(const Approach& approach, double top) {
  const MotionLimits limits(approach.weakest);
  double most = 0.0;
  for (int k = 0; k <= kAccelerations; ++k) {
    const double acceleration = approach.weakest.a_max.x * k / kAccelerations;
    const double ends_in = approach.weakest.j_max.x > 0.0 ? acceleration / approach.weakest.j_max.x : kMinDuration;
    const double speed = top - 0.5 * acceleration * ends_in;
    if (speed >= 0.0) most = larger(most, needed_range(approach, limits, speed, acceleration));
  }
  return most;
}

}  // namespace

Status limit_speed(const FromBeyond& what, const FlightSpec& spec, double clearance, Limits& limits,
                   Trajectory& room) noexcept {
  if (!finite(what.range) || !finite(what.delay) || !finite(what.speed) || !finite(what.size) || !finite(clearance))
    return Status::kNonFiniteInput;
  const bool is_valid = what.range > 0.0 && what.delay >= 0.0 && what.speed >= 0.0 && what.size >= 0.0 &&
                        clearance >= 0.0 && spec.tick > 0 && spec.work_per_tick > 0;
  if (!is_valid || limits.rate_max > 0.0) return Status::kInvalidArgument;
  const Verdict ranges = validate_limits(limits);
  if (ranges.status != Status::kOk) return ranges.status;
  // The tick that is told of the thing, and those before the brake.
  const double lead = 1e-9 * static_cast<double>((Evasion::ticks_after(0, spec) + 1) * spec.tick);
  const Approach approach{what, weakest_of(limits), lead, clearance, room};
  const double top = top_speed(limits);
  const auto fits = [&](double share) { return needed_below(approach, share * top) <= what.range; };
  if (fits(1.0)) return Status::kOk;
  if (!fits(kLeastShare)) return Status::kLimitsInvalid;
  double share = kLeastShare;
  double above = 1.0;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (share + above);
    (fits(middle) ? share : above) = middle;
  }
  limits.v_max = share * limits.v_max;
  limits.v_min = share * limits.v_min;
  limits.v_horizontal *= share;
  return Status::kOk;
}

}  // namespace tern
