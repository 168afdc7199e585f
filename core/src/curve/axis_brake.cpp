// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "curve/axis_brake.hpp"

#include "base/bounds.hpp"
#include "curve/brake.hpp"

namespace tern {
namespace {

/// The longest hold, in quarters of a ramp. A longer one is as good as no stop.
constexpr double kMostQuarters = 1e6;

/// The motion of one axis: a ramp from acceleration `from` to `to`, a hold of `to`, and a ramp back to none.
struct AxisMotion {
  double position;
  double velocity;
  double from;
  double to;
  double hold;
  double jerk;  ///< jerk at the beginning
};

/// Smallest multiple of a quarter of the ramp that is no less than `time`.
double in_quarters(double time, double ramp) {
  const double quarters = 4.0 * time / ramp;
  if (!(quarters > 0.0)) return 0.0;
  if (quarters >= kMostQuarters) return 0.25 * ramp * kMostQuarters;
  const auto whole = static_cast<int>(quarters);
  return 0.25 * ramp * (static_cast<double>(whole) < quarters ? whole + 1 : whole);
}

AxisMotion motion_of(const State& state, const Bounds& bounds, double ramp, int a) {
  AxisMotion motion{axis(state.position, a), axis(state.velocity, a), axis(state.acceleration, a), 0.0, 0.0,
                    axis(state.jerk, a)};
  // The velocity that is left if the first ramp only undoes the acceleration. A ramp and the hold have to take it away.
  const double excess = motion.velocity + 0.5 * ramp * motion.from + kJerkToVelocity * ramp * ramp * motion.jerk;
  const double limit = excess > 0.0 ? -axis(bounds.lower, a) : axis(bounds.upper, a);
  motion.hold = in_quarters(absolute(excess) / limit - ramp, ramp);
  motion.to = -excess / (ramp + motion.hold);
  return motion;
}

/// Moves `jet`, derivatives 0 to 3 at the beginning of a ramp to acceleration `to`, on by `time` seconds. The
/// acceleration follows 3 u^2 - 2 u^3.
void ramp_on(double time, double ramp, double to, double* jet) {
  const double u = time / ramp;
  const double change = to - jet[2];
  const double square = u * u;
  const double position =
      jet[0] + time * jet[1] + ramp * ramp * (0.5 * jet[2] * square + change * (0.25 - 0.1 * u) * square * square);
  const double velocity = jet[1] + ramp * (jet[2] * u + change * (1.0 - 0.5 * u) * square * u);
  jet[3] = change * 6.0 * (u - square) / ramp;
  jet[2] = jet[2] + change * (3.0 - 2.0 * u) * square;
  jet[1] = velocity;
  jet[0] = position;
}

/// Derivatives 0 to 3 of the axis after `time` >= `ramp` seconds.
void jet_at(const AxisMotion& motion, double ramp, double time, double* jet) {
  jet[0] = motion.position;
  jet[1] = motion.velocity;
  jet[2] = motion.from;
  jet[3] = 0.0;
  ramp_on(ramp, ramp, motion.to, jet);
  jet[0] += kJerkToWay * ramp * ramp * ramp * motion.jerk;
  jet[1] += kJerkToVelocity * ramp * ramp * motion.jerk;
  if (time <= ramp) return;
  const double held = smaller(time - ramp, motion.hold);
  jet[0] += held * jet[1] + 0.5 * held * held * motion.to;
  jet[1] += held * motion.to;
  jet[2] = motion.to;
  jet[3] = 0.0;
  const double rest = time - ramp - motion.hold;
  if (rest <= 0.0) return;
  ramp_on(smaller(rest, ramp), ramp, 0.0, jet);
  if (rest >= ramp) jet[1] = jet[2] = jet[3] = 0.0;
}

/// The times at which the motion of some axis changes from ramp to hold or back, in order, each once.
int sorted_times(const AxisMotion* motions, double ramp, double* times) {
  int count = 0;
  times[count++] = ramp;
  for (int k = 0; k < 6; ++k) {
    const double time = ramp + motions[k / 2].hold + (k % 2 == 0 ? 0.0 : ramp);
    int at = count;
    bool known = false;
    for (int i = 0; i < count; ++i) known = known || absolute(times[i] - time) < 0.125 * ramp;
    if (known) continue;
    for (; at > 0 && times[at - 1] > time; --at) times[at] = times[at - 1];
    times[at] = time;
    ++count;
  }
  return count;
}

}  // namespace

AxisBrake make_axis_brake(const State& state, const MotionLimits& limits, double ramp) noexcept {
  const Bounds& bounds = limits.acceleration;
  AxisMotion motions[3];
  for (int a = 0; a < 3; ++a) motions[a] = motion_of(state, bounds, ramp, a);
  double times[kAxisBrakeSegments];
  AxisBrake brake;
  brake.segments = sorted_times(motions, ramp, times);
  brake.joint[0] = JointState{{state.position, state.velocity, state.acceleration, state.jerk}};
  for (int i = 0; i < brake.segments; ++i) {
    brake.duration[i] = times[i] - (i == 0 ? 0.0 : times[i - 1]);
    for (int a = 0; a < 3; ++a) {
      double jet[kJointOrder];
      jet_at(motions[a], ramp, times[i], jet);
      for (int k = 0; k < kJointOrder; ++k) axis(brake.joint[i + 1].d[k], a) = jet[k];
    }
  }
  const Vec3 zero{0.0, 0.0, 0.0};
  for (int k = 1; k < kJointOrder; ++k) brake.joint[brake.segments].d[k] = zero;
  return brake;
}

}  // namespace tern
