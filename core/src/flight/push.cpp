// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "curve/brake.hpp"
#include "curve/motion_limits.hpp"
#include "flight/branch.hpp"

namespace tern {
namespace {

/// A jerk of less is rounding, m/s^3.
constexpr double kRoundedJerk = 1e-6;

bool append_within(const JointState& from, const JointState& to, double time, const MotionLimits& limits,
                   Trajectory& out) {
  return append_between(from, to, time, out) && within_limits(out.segments[out.count - 1], limits, kStopTolerance);
}

}  // namespace

/// The push lasts half of the time from rest to rest.
bool append_push(const JointState& from, const MotionLimits& limits, const Vec3& side, double far,
                 Trajectory& out) noexcept {
  JointState now = from;
  if (length(from.d[3]) > kRoundedJerk) {
    const double time = settle_time(from, limits);
    now = settled(from, time);
    if (!append_within(from, now, time, limits, out)) return false;
  }
  const Vec3 acceleration = ((1.0 - kJerkMargin) / gauge(limits.acceleration, side)) * side;
  const double gentlest = kSmoothStepPeak * ramp_gauge(limits, acceleration - now.d[2]);
  const double ramp = larger(kMinDuration, (1.0 + kJerkMargin) * gentlest);
  const double hold = larger(kMinDuration, square_root(far / length(acceleration)) - ramp);
  const JointState pushed = after_ramp(now, acceleration, ramp);
  const JointState fast = after_ramp(pushed, acceleration, hold);
  return append_within(now, pushed, ramp, limits, out) && append_within(pushed, fast, hold, limits, out) &&
         append_flat_stop(fast, limits, out);
}

}  // namespace tern
