// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "curve/stopping.hpp"

#include "base/bounds.hpp"
#include "curve/bezier.hpp"
#include "curve/hermite.hpp"
#include "curve/motion_limits.hpp"
#include "curve/rest.hpp"

namespace tern {
namespace {

constexpr double kHalfRoot = 0.70710678118654752;  // sqrt(1 / 2)

/// One of the swerves.
struct Swerve {
  int side;
  double size;      ///< part of the largest sideways displacement that the limits allow
  double strength;  ///< part of the limits on acceleration that the braking takes
  int shape;        ///< Brake shape of the braking
};

Swerve swerve_of(int index) {
  constexpr double kStrengths[kSwerveStrengths] = {1.0, 0.7};
  constexpr int kShapes[kSwerveShapes] = {kBrakeShapes - 1, 2};
  constexpr double kSizes[kSwerveSizes] = {1.0, 0.5, 0.25};
  Swerve swerve{};
  swerve.side = index % kSwerveSides;
  index /= kSwerveSides;
  swerve.size = kSizes[index % kSwerveSizes];
  index /= kSwerveSizes;
  swerve.strength = kStrengths[index % kSwerveStrengths];
  swerve.shape = kShapes[index / kSwerveStrengths];
  return swerve;
}

/// One of the turns.
struct Turn {
  int side;
  double strength;  ///< part of the limit on acceleration towards the side
  double braking;   ///< part of the limit on acceleration that brakes during the turn
  double hold;      ///< duration, in parts of the time that braking at the limit takes
};

Turn turn_of(int index) {
  constexpr double kStrengths[kTurnStrengths] = {1.0, 0.5, 0.25};
  constexpr double kBrakings[kTurnBrakings] = {0.7, 0.0, 0.3};
  constexpr double kHolds[kTurnHolds] = {0.5, 0.25, 0.125, 1.0};
  Turn turn{};
  turn.hold = kHolds[index % kTurnHolds];
  index /= kTurnHolds;
  turn.braking = kBrakings[index % kTurnBrakings];
  index /= kTurnBrakings;
  turn.strength = kStrengths[index % kTurnStrengths];
  turn.side = index / kTurnStrengths;
  return turn;
}

MotionLimits weaker(const MotionLimits& limits, double strength) {
  MotionLimits result = limits;
  result.acceleration = scaled(strength, limits.acceleration);
  return result;
}

/// The direction of motion; upwards for none.
Vec3 heading_of(const Vec3& velocity) {
  const double speed = length(velocity);
  return speed > 0.0 ? (1.0 / speed) * velocity : Vec3{0.0, 0.0, 1.0};
}

/// One of eight unit vectors at right angles to the heading.
Vec3 sideways(const Vec3& heading, int side) {
  constexpr double kCosines[kSwerveSides] = {1.0, kHalfRoot, 0.0, -kHalfRoot, -1.0, -kHalfRoot, 0.0, kHalfRoot};
  const Vec3 u = perpendicular(heading);
  return kCosines[side] * u + kCosines[(side + 6) % kSwerveSides] * cross(heading, u);
}

/// The acceleration of a turn. The last side is the one to which the state already turns; the turn is as sharp as that,
/// or a part of it.
Vec3 turning(const State& state, const MotionLimits& limits, const Turn& turn) {
  const Vec3 heading = heading_of(state.velocity);
  const Bounds& bounds = limits.acceleration;
  const Vec3 slower = (-turn.braking / gauge(bounds, kZero - heading)) * heading;
  if (turn.side == kTurnSides - 1) {
    return slower + turn.strength * (state.acceleration - dot(state.acceleration, heading) * heading);
  }
  const Vec3 side = sideways(heading, turn.side);
  const Vec3 wanted = slower + (turn.strength / gauge(bounds, side)) * side;
  return (1.0 / larger(1.0, gauge(bounds, wanted))) * wanted;
}

/// Bernstein coefficients of 35 s^4 - 84 s^5 + 70 s^6 - 20 s^7, the step from rest to rest, over [begin, end] within
/// [0, 1].
void step_between(double begin, double end, double* coefficients) {
  for (int k = 0; k <= kDegree; ++k) coefficients[k] = k < kControlPoints / 2 ? 0.0 : 1.0;
  keep_first_part(end, coefficients);
  keep_last_part(begin / end, coefficients);
}

/// Adds a sideways step to the braking, which lasts as long as the braking and moves its end by `displacement`.
void add_swerve(const Vec3& displacement, const Brake& brake, Segment* segments) {
  double total = 0.0;
  for (const double duration : brake.duration) total += duration;
  double begin = 0.0;
  for (int part = 0; part < kBrakeSegments; ++part) {
    const double end = part + 1 == kBrakeSegments ? total : begin + brake.duration[part];
    double step[kControlPoints];
    step_between(begin / total, end / total, step);
    for (int k = 0; k < kControlPoints; ++k)
      segments[part].points[k] = segments[part].points[k] + step[k] * displacement;
    begin = end;
  }
}

/// Makes neighbours share their joint's position bit for bit, whatever rounding the swerve added.
void close_joints(Stopping& stopping) {
  for (int i = 1; i < stopping.count; ++i) stopping.segments[i].points[0] = stopping.segments[i - 1].points[kDegree];
}

bool keeps_limits(const Stopping& stopping, const MotionLimits& limits) {
  for (int i = 0; i < stopping.count; ++i) {
    if (!within_limits(stopping.segments[i], limits, kStopTolerance)) return false;
  }
  return true;
}

Segment segment_between(const JointState& first, const JointState& second, double duration) {
  Segment segment{};
  segment.duration = duration;
  control_points(first, second, duration, segment.points);
  return segment;
}

State state_of(const JointState& joint) {
  return {joint.d[0], joint.d[1], joint.d[2], joint.d[3]};
}

/// Ramps to the turn's acceleration and holds it.
State add_turn(const State& state, const MotionLimits& limits, int index, double least, Stopping& out) {
  const Turn turn = turn_of(index);
  const Vec3 acceleration = turning(state, limits, turn);
  const double ramp = larger(least, kSmoothStepPeak * ramp_gauge(limits, acceleration - state.acceleration));
  const double hold = larger(least, turn.hold * gauge(limits.acceleration, kZero - state.velocity));
  const JointState first{{state.position, state.velocity, state.acceleration, state.jerk}};
  const JointState second = after_ramp(first, acceleration, ramp);
  const JointState third = after_ramp(second, acceleration, hold);
  out.segments[out.count++] = segment_between(first, second, ramp);
  out.segments[out.count++] = segment_between(second, third, hold);
  return state_of(third);
}

void add_brake(const State& state, const MotionLimits& limits, const Swerve& swerve, double least, Stopping& out) {
  const Brake brake = make_brake(state, weaker(limits, swerve.strength), swerve.shape, least);
  Segment* const segments = out.segments + out.count;
  for (int part = 0; part < kBrakeSegments; ++part) segments[part] = brake_segment(brake, part, 0);
  out.count += kBrakeSegments;
  if (!(swerve.size > 0.0)) return;
  const Vec3 side = sideways(heading_of(state.velocity), swerve.side);
  const double time = (brake.duration[0] + brake.duration[1]) + brake.duration[2];
  const Bounds& acceleration = limits.acceleration;
  const double pull = larger(gauge(acceleration, side), gauge(acceleration, kZero - side));
  add_swerve((swerve.size * time * time / (kRestPeakAcceleration * pull)) * side, brake, segments);
}

constexpr Swerve straight(int shape) {
  return {0, 0.0, 1.0, shape};
}

/// A ramp in which every axis can get from its acceleration to its limit.
double gentlest_ramp(const State& state, const MotionLimits& limits) {
  const double turning_jerk = limits.rate > 0.0 ? limits.rate * kGravity : kUnlimited;
  double ramp = 0.0;
  for (int a = 0; a < 3; ++a) {
    const double limit = larger(axis(limits.acceleration.upper, a), -axis(limits.acceleration.lower, a));
    const double change = limit + absolute(axis(state.acceleration, a));
    ramp = larger(ramp, kSmoothStepPeak * change / smaller(turning_jerk, axis(limits.jerk.upper, a)));
  }
  return ramp;
}

void add_axis_brake(const State& state, const MotionLimits& limits, double ramp, Stopping& out) {
  MotionLimits each = limits;
  each.acceleration = inner_box(limits.acceleration);
  const AxisBrake brake = make_axis_brake(state, each, larger(ramp, gentlest_ramp(state, each)));
  for (int i = 0; i < brake.segments; ++i) {
    out.segments[out.count++] = segment_between(brake.joint[i], brake.joint[i + 1], brake.duration[i]);
  }
}

/// Adds manoeuvre `index`, 0 .. kStoppingManoeuvres - 1, with ramps of at least `least` seconds.
void add_manoeuvre(const State& state, const MotionLimits& limits, int index, double least, Stopping& out) {
  if (index < kBrakeShapes) return add_brake(state, limits, straight(index), least, out);
  index -= kBrakeShapes;
  if (index < kAxisBrakes) return add_axis_brake(state, limits, index == 0 ? least : 4.0 * least, out);
  index -= kAxisBrakes;
  if (index >= 2 * kTurns) return add_brake(state, limits, swerve_of(index - 2 * kTurns), least, out);
  const State turned = add_turn(state, limits, index / 2, least, out);
  if (index % 2 == 0) return add_brake(turned, limits, straight(kBrakeShapes - 1), least, out);
  add_axis_brake(turned, limits, least, out);
}

/// Adds a ramp that takes the acceleration back to none. The velocity changes by half of acceleration times duration,
/// so it keeps its limit if it does so at the end.
State level_off(const State& state, const MotionLimits& limits, Stopping& out) {
  const Bounds& bounds = limits.velocity;
  double time = kMinDuration;
  for (int i = 0; i < kLevelHalvings; ++i) {
    if (gauge(bounds, state.velocity + (0.5 * time) * state.acceleration) <= 1.0 + kLimitTolerance) break;
    time *= 0.5;
  }
  const JointState first{{state.position, state.velocity, state.acceleration, state.jerk}};
  const JointState second = after_ramp(first, kZero, time);
  out.segments[out.count++] = segment_between(first, second, time);
  return state_of(second);
}

}  // namespace

bool make_stopping(const State& state, const MotionLimits& limits, int choice, Stopping& out) noexcept {
  const double least = choice < kStoppingManoeuvres ? kMinDuration : kSharpRamp;
  const int index = choice % kStoppingManoeuvres;
  out.count = 0;
  add_manoeuvre(state, limits, index, least, out);
  close_joints(out);
  if (keeps_limits(out, limits)) return true;
  if (index >= kBrakeShapes) return false;
  out.count = 0;
  add_brake(level_off(state, limits, out), limits, straight(index), least, out);
  close_joints(out);
  return keeps_limits(out, limits);
}

void reverse(Stopping& stopping) noexcept {
  for (int i = 0; 2 * i < stopping.count; ++i) {
    const Segment segment = stopping.segments[i];
    stopping.segments[i] = reversed(stopping.segments[stopping.count - 1 - i]);
    stopping.segments[stopping.count - 1 - i] = reversed(segment);
  }
}

}  // namespace tern
