// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "proof/proven_joints.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

constexpr int kOrders = 3;
/// Rounding of a difference of control points, in units of their largest coordinate's last place.
constexpr double kUlps = 64.0 / 4503599627370496.0;

/// Position, velocity and acceleration at an end of a segment, and what rounding may do to each.
struct End {
  Vec3 at[kOrders];
  double rounding[kOrders];
};

double size_of(const Segment& segment) {
  double most = 0.0;
  for (const Vec3& p : segment.points) {
    for (int a = 0; a < 3; ++a) most = larger(most, axis(p, a) < 0.0 ? -axis(p, a) : axis(p, a));
  }
  return most;
}

/// The end at control point `first`. `step` is 1 at the segment's beginning and -1 at its end: derivatives of even
/// order look the same from both ends.
End end_of(const Segment& segment, int first, int step) {
  const Vec3* const p = segment.points;
  const double rate = kDegree / segment.duration;
  const double square = rate * (kDegree - 1) / segment.duration;
  const double rounding = kUlps * size_of(segment);
  const Vec3 towards = p[first + step] - p[first];
  const Vec3 bend = (p[first + 2 * step] - p[first + step]) - towards;
  return {{p[first], step * rate * towards, square * bend}, {rounding, rate * rounding, square * rounding}};
}

bool near(const Vec3& a, const Vec3& b, double most) {
  for (int k = 0; k < 3; ++k) {
    const double apart = axis(a, k) - axis(b, k);
    if (!(apart <= most && apart >= -most)) return false;
  }
  return true;
}

bool meet(const End& before, const End& after) {
  for (int k = 0; k < kOrders; ++k) {
    if (!near(before.at[k], after.at[k], kJointJump[k] + before.rounding[k] + after.rounding[k])) return false;
  }
  return true;
}

bool rests(const End& end) {
  for (int k = 1; k < kOrders; ++k) {
    if (!near(end.at[k], Vec3{}, kJointJump[k] + end.rounding[k])) return false;
  }
  return true;
}

}  // namespace

bool follows(const Sample& before, const Sample& after) noexcept {
  return near(before.position, after.position, kJointJump[0]) && near(before.velocity, after.velocity, kJointJump[1]) &&
         near(before.acceleration, after.acceleration, kJointJump[2]);
}

bool joints_hold(const Trajectory& trajectory) noexcept {
  if (trajectory.count < 1 || trajectory.count > kMaxSegments) return false;
  for (int i = 1; i < trajectory.count; ++i) {
    if (!meet(end_of(trajectory.segments[i - 1], kDegree, -1), end_of(trajectory.segments[i], 0, 1))) return false;
  }
  return rests(end_of(trajectory.segments[trajectory.count - 1], kDegree, -1));
}

}  // namespace tern
