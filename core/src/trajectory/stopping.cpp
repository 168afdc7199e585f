// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/stopping.hpp"

#include "base/bounds.hpp"
#include "times/times.hpp"
#include "trajectory/motion_limits.hpp"
#include "trajectory/stop_and_go.hpp"

namespace tern {
namespace {

constexpr Vec3 kZero{0.0, 0.0, 0.0};
constexpr double kHalfRoot = 0.70710678118654752;  // sqrt(1 / 2)

/// One swerve of kSwerves.
struct Swerve {
  int direction;
  double size;      ///< part of the largest sideways way that the limits allow
  double strength;  ///< part of the limits on acceleration that the braking takes
  int shape;        ///< of the braking
};

Swerve swerve_of(int index) {
  constexpr double kStrengths[kSwerveStrengths] = {1.0, 0.7};
  constexpr int kShapes[kSwerveShapes] = {kBrakeShapes - 1, 2};
  constexpr double kSizes[kSwerveSizes] = {1.0, 0.5, 0.25};
  Swerve swerve{};
  swerve.direction = index % kSwerveDirections;
  index /= kSwerveDirections;
  swerve.size = kSizes[index % kSwerveSizes];
  index /= kSwerveSizes;
  swerve.strength = kStrengths[index % kSwerveStrengths];
  swerve.shape = kShapes[index / kSwerveStrengths];
  return swerve;
}

Limits weaker(const Limits& limits, double strength) {
  Limits result = limits;
  result.a_max = strength * limits.a_max;
  result.a_min = strength * limits.a_min;
  result.a_horizontal = strength * limits.a_horizontal;
  return result;
}

/// One of eight unit vectors at right angles to the velocity.
Vec3 sideways(const Vec3& velocity, int direction) {
  constexpr double kCosines[kSwerveDirections] = {1.0, kHalfRoot, 0.0, -kHalfRoot, -1.0, -kHalfRoot, 0.0, kHalfRoot};
  const double speed = length(velocity);
  const Vec3 along = speed > 0.0 ? (1.0 / speed) * velocity : Vec3{0.0, 0.0, 1.0};
  const Vec3 u = perpendicular(along);
  return kCosines[direction] * u + kCosines[(direction + 6) % kSwerveDirections] * cross(along, u);
}

/// Bernstein coefficients of 35 s^4 - 84 s^5 + 70 s^6 - 20 s^7 over [begin, end] within [0, 1]: from rest to rest.
void step_between(double begin, double end, double* coefficients) {
  double* const c = coefficients;
  for (int k = 0; k <= kDegree; ++k) c[k] = k < kControlPoints / 2 ? 0.0 : 1.0;
  // de Casteljau at `end` leaves the first piece, then at begin / end its last.
  for (int level = 1; level <= kDegree; ++level) {
    for (int k = kDegree; k >= level; --k) c[k] = (1.0 - end) * c[k - 1] + end * c[k];
  }
  const double at = begin / end;
  for (int level = 1; level <= kDegree; ++level) {
    for (int k = 0; k <= kDegree - level; ++k) c[k] = (1.0 - at) * c[k] + at * c[k + 1];
  }
}

/// Moves the braking's end sideways, from its beginning on.
void add_swerve(const Vec3& way, const Brake& brake, Segment* segments) {
  double total = 0.0;
  for (const double duration : brake.duration) total += duration;
  double begin = 0.0;
  for (int part = 0; part < kBrakeSegments; ++part) {
    const double end = part + 1 == kBrakeSegments ? total : begin + brake.duration[part];
    double step[kControlPoints];
    step_between(begin / total, end / total, step);
    for (int k = 0; k < kControlPoints; ++k) segments[part].points[k] = segments[part].points[k] + step[k] * way;
    begin = end;
  }
}

/// Neighbours share their joint's position to the bit, whatever adding the swerve rounded.
void close_joints(Stopping& stopping) {
  for (int i = 1; i < stopping.count; ++i) stopping.segments[i].points[0] = stopping.segments[i - 1].points[kDegree];
}

bool keeps_limits(const Stopping& stopping, const Limits& limits) {
  for (int i = 0; i < stopping.count; ++i) {
    if (!within_limits(stopping.segments[i], limits, kStopTolerance)) return false;
  }
  return true;
}

void add_brake(const State& state, const Limits& limits, int choice, Stopping& out) {
  const bool straight = choice < kBrakeShapes;
  const Swerve swerve = straight ? Swerve{0, 0.0, 1.0, choice} : swerve_of(choice - kBrakeShapes);
  const Brake brake = make_brake(state, weaker(limits, swerve.strength), swerve.shape);
  Segment* const segments = out.segments + out.count;
  for (int part = 0; part < kBrakeSegments; ++part) segments[part] = brake_segment(brake, part, 0);
  out.count += kBrakeSegments;
  if (straight) return;
  const Vec3 side = sideways(state.velocity, swerve.direction);
  const double time = (brake.duration[0] + brake.duration[1]) + brake.duration[2];
  const Bounds acceleration = acceleration_bounds(limits);
  const double pull = larger(gauge(acceleration, side), gauge(acceleration, kZero - side));
  add_swerve((swerve.size * time * time / (kRestPeakAcceleration * pull)) * side, brake, segments);
  close_joints(out);
}

/// A ramp that takes the acceleration back to none. The speed changes by half of acceleration times duration, and so
/// stays within its limit where the end does.
State level_off(const State& state, const Limits& limits, Stopping& out) {
  const Bounds bounds = velocity_bounds(limits);
  double time = kMinDuration;
  for (int i = 0; i < kLevelHalvings; ++i) {
    if (gauge(bounds, state.velocity + (0.5 * time) * state.acceleration) <= 1.0 + kLimitTolerance) break;
    time *= 0.5;
  }
  const JointState first{{state.position, state.velocity, state.acceleration, kZero}};
  const JointState second = after_ramp(first, kZero, time);
  Segment& segment = out.segments[out.count++];
  segment.duration = time;
  segment.polyhedron = 0;
  control_points(first, second, time, segment.points);
  return {second.d[0], second.d[1], kZero};
}

}  // namespace

bool make_stopping(const State& state, const Limits& limits, int choice, Stopping& out) noexcept {
  out.count = 0;
  add_brake(state, limits, choice, out);
  if (keeps_limits(out, limits)) return true;
  out.count = 0;
  add_brake(level_off(state, limits, out), limits, choice, out);
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
