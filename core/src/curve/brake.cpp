// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "curve/brake.hpp"

#include "base/bounds.hpp"
#include "curve/hermite.hpp"
#include "curve/motion_limits.hpp"

namespace tern {
namespace {

/// A ramp's acceleration follows the smooth step 3 u^2 - 2 u^3. The step's integral over [0, 1] is 1/2, so the speed
/// changes by the mean of both accelerations times the ramp's time. The second integral is 3/20, so the way changes by
/// these parts of the first and the second acceleration, times the squared time.
constexpr double kFirstPart = 0.35;
constexpr double kSecondPart = 0.15;

/// Length of a ramp that surely keeps the limits on jerk. A ramp of r seconds that changes the acceleration by c has a
/// jerk of 1.5 c / r at most. A brake's first ramp changes it by no more than 1.5 times the acceleration, plus the
/// speed over r.
double gentle_ramp(const State& state, const MotionLimits& limits) {
  return square_root(kSmoothStepPeak * ramp_gauge(limits, state.velocity)) +
         kSmoothStepPeak * 1.5 * ramp_gauge(limits, state.acceleration);
}

double ramp_time(const State& state, const MotionLimits& limits, int shape, double least) {
  double time = gauge(limits.acceleration, kZero - state.velocity);
  double smooth = gentle_ramp(state, limits);
  for (int i = 0; i < shape; ++i) {
    time *= kBrakeSharper;
    smooth *= kBrakeLessSmooth;
  }
  return larger(larger(least, time), smooth);
}

/// Makes the brake in place: a returned brake would take up the stack twice.
void fill(const State& state, const MotionLimits& limits, int shape, double least, Brake& brake) {
  const double ramp = ramp_time(state, limits, shape, least);
  // The velocity that is left if the first ramp only undoes the acceleration. The steady deceleration takes it away
  // over a ramp and the hold.
  const Vec3 excess = state.velocity + (0.5 * ramp) * state.acceleration + (kJerkToVelocity * ramp * ramp) * state.jerk;
  const double hold = larger(least, gauge(limits.acceleration, kZero - excess) - ramp);
  const Vec3 deceleration = (-1.0 / (ramp + hold)) * excess;
  brake.duration[0] = brake.duration[2] = ramp;
  brake.duration[1] = hold;
  brake.joint[0] = JointState{{state.position, state.velocity, state.acceleration, state.jerk}};
  brake.joint[1] = after_ramp(brake.joint[0], deceleration, ramp);
  brake.joint[2] = after_ramp(brake.joint[1], deceleration, hold);
  brake.joint[3] = after_ramp(brake.joint[2], kZero, ramp);
  brake.joint[3].d[1] = kZero;
}

bool holds(const Brake& brake, const Polyhedron& polyhedron, const MotionLimits& limits) {
  for (int part = 0; part < kBrakeSegments; ++part) {
    const Segment segment = brake_segment(brake, part, 0);
    if (!inside(segment, polyhedron) || !within_limits(segment, limits)) return false;
  }
  return true;
}

}  // namespace

JointState after_ramp(const JointState& from, const Vec3& acceleration, double time) noexcept {
  const double square = time * time;
  const Vec3 way = kFirstPart * from.d[2] + kSecondPart * acceleration + (kJerkToWay * time) * from.d[3];
  return JointState{{from.d[0] + time * from.d[1] + square * way,
                     from.d[1] + (0.5 * time) * (from.d[2] + acceleration) + (kJerkToVelocity * square) * from.d[3],
                     acceleration, kZero}};
}

Brake make_brake(const State& state, const MotionLimits& limits, int shape, double least) noexcept {
  Brake brake;
  fill(state, limits, shape, least, brake);
  return brake;
}

Segment brake_segment(const Brake& brake, int part, int polyhedron) noexcept {
  Segment segment{};
  segment.duration = brake.duration[part];
  segment.polyhedron = polyhedron;
  control_points(brake.joint[part], brake.joint[part + 1], segment.duration, segment.points);
  return segment;
}

bool find_brake(const State& state, const Polyhedron& polyhedron, const MotionLimits& limits, Brake& brake) noexcept {
  for (int shape = 0; shape < kBrakeShapes; ++shape) {
    fill(state, limits, shape, kMinDuration, brake);
    if (holds(brake, polyhedron, limits)) return true;
  }
  return false;
}

}  // namespace tern
