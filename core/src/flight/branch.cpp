// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/branch.hpp"

#include "base/capacity.hpp"
#include "base/math.hpp"
#include "curve/bezier.hpp"

namespace tern {
namespace {

/// A stop need not settle a jerk that is only rounding, m/s^3.
constexpr double kNoJerk = 1e-6;

}  // namespace

JointState settled(const JointState& from, double time) noexcept {
  const Vec3& p = from.d[0];
  const Vec3& v = from.d[1];
  const Vec3& a = from.d[2];
  const Vec3& j = from.d[3];
  const double square = time * time;
  return JointState{{p + time * v + (0.5 * square) * a + (0.125 * square * time) * j, v + time * a + (square / 3.0) * j,
                     a + (0.5 * time) * j, kZero}};
}

double settle_time(const JointState& from, const MotionLimits& limits) noexcept {
  double time = kSettleTime;
  for (int i = 0; i < kSettleHalvings; ++i) {
    const JointState to = settled(from, time);
    if (gauge(limits.velocity, to.d[1]) <= 1.0 && gauge(limits.acceleration, to.d[2]) <= 1.0) break;
    time *= 0.5;
  }
  return time;
}

JointState joint_at(const Trajectory& plan, double t, const Vec3& origin) noexcept {
  const Sample sample = evaluate(plan, t);
  return JointState{{sample.position - origin, sample.velocity, sample.acceleration, sample.jerk}};
}

bool append_between(const JointState& from, const JointState& to, double time, Trajectory& out) noexcept {
  if (out.count == kMaxSegments) return false;
  Segment& segment = out.segments[out.count++];
  segment.duration = time;
  segment.polyhedron = 0;
  control_points(from, to, time, segment.points);
  return true;
}

double off_joints(const Trajectory& plan, double t) noexcept {
  double begin = 0.0;
  for (int i = 0; i < plan.count && begin < t; ++i) {
    const double end = begin + plan.segments[i].duration;
    if (t < end) return t - begin < kSliver ? begin : t;
    begin = end;
  }
  return t;
}

void take_first_part(const Trajectory& plan, double t, Trajectory& out) noexcept {
  out.begin = plan.begin;
  out.origin = plan.origin;
  out.count = 0;
  double begin = 0.0;
  for (int i = 0; i < plan.count && t > begin; ++i) {
    Segment& segment = out.segments[out.count++];
    segment = plan.segments[i];
    const double end = begin + segment.duration;
    if (t < end) {
      const double u = (t - begin) / segment.duration;
      keep_first_part(u, segment.points);
      segment.duration *= u;
    }
    begin = end;
  }
}

void take_remainder(const Trajectory& plan, double t, double ahead, Trajectory& out) noexcept {
  out.origin = plan.origin;
  out.count = 0;
  double begin = 0.0;
  for (int i = 0; i < plan.count && begin < t + ahead; ++i) {
    const double end = begin + plan.segments[i].duration;
    if (end > t) {
      Segment& segment = out.segments[out.count++];
      segment = plan.segments[i];
      if (begin < t) {
        keep_last_part((t - begin) / segment.duration, segment.points);
        segment.duration = end - t;
      }
    }
    begin = end;
  }
  if (out.count > 0) return;
  const JointState rest{{plan.segments[plan.count - 1].points[kDegree], kZero, kZero, kZero}};
  append_between(rest, rest, kMinDuration, out);
}

bool append_stop(const JointState& from, const MotionLimits& limits, int way, Stopping& scratch,
                 Trajectory& out) noexcept {
  JointState now = from;
  if (length(from.d[3]) > kNoJerk) {
    const double time = settle_time(from, limits);
    now = settled(from, time);
    if (is_full(!append_between(from, now, time, out))) return false;
  }
  if (!make_stopping({now.d[0], now.d[1], now.d[2]}, limits, kStops - 1 - way, scratch)) return false;
  if (is_full(scratch.count > kMaxSegments - out.count)) return false;
  for (int i = 0; i < scratch.count; ++i) out.segments[out.count++] = scratch.segments[i];
  return true;
}

}  // namespace tern
