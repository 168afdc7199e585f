// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/turning.hpp"

#include "base/math.hpp"
#include "curve/bezier.hpp"
#include "trajectory/turning_rows.hpp"

namespace tern {
namespace {

/// The least vertical thrust at first, of the hover's.
constexpr double kFirstThrust = 0.6;
/// Of the jerk that the thrust allows: the next solution is not as well known.
constexpr double kJerkShare = 0.97;
/// Of the rate's limit: rates below and above count as these.
constexpr double kLeastRate = 0.05;
constexpr double kMostRate = 20.0;
/// A jerk whose part across the thrust is smaller than this has no sure direction.
constexpr double kSureDirection = 1e-6;

constexpr Vec3 kUp{0.0, 0.0, 1.0};

/// Lets the rows of half a segment have a boundary state.
void allow(const JointState& state, const MotionLimits& limits, TurningRows* rows) {
  const Vec3 force = state.d[2] + kGravity * kUp;
  for (int r = 0; r <= kJerkPoints / 2; ++r) {
    const double across = larger(limits.rate * length(force), length(cross(state.d[3], rows[r].thrust)));
    rows[r].most = larger(rows[r].most, across);
    rows[r].side = larger(rows[r].side, across);
    rows[r].least = smaller(rows[r].least, dot(force, rows[r].thrust));
  }
}

void allow_ends(const Chain& chain, const MotionLimits& limits, Turning& turning) {
  allow(chain.start, limits, turning.rows[0]);
  allow(chain.goal, limits, turning.rows[chain.count - 1] + kJerkPoints / 2);
}

/// A point of kHodographPoints, without powers of the time.
Vec3 point_of(const Segment& segment, const double* weights) {
  Vec3 sum = kZero;
  for (int k = 0; k < kControlPoints; ++k) sum = sum + weights[k] * segment.points[k];
  return sum;
}

/// The least part along a direction of the thrust's points that are nearest to the instant.
double least_thrust(const Segment& segment, int instant, const Vec3& along) {
  const double unit = 1.0 / power_of(segment.duration, 2);
  double least = kUnlimited;
  for (int s = 0; s < kAccelerationPoints; ++s) {
    if (nearest_jerk_point(s) != instant) continue;
    least = smaller(least, unit * dot(point_of(segment, kHodographPoints.acceleration[s]), along));
  }
  return least + kGravity * along.z;
}

/// The unit vector along the part of a jerk across a direction; any one across it if there is no such part.
Vec3 turn_of(const Vec3& jerk, const Vec3& along) {
  const Vec3 across = jerk - dot(jerk, along) * along;
  const double size = length(across);
  if (size > kSureDirection * (1.0 + length(jerk))) return (1.0 / size) * across;
  const Vec3 any = cross(along, absolute(along.x) < 0.7 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0});
  return (1.0 / length(any)) * any;
}

/// The rows at one instant, where the plan has this thrust and this jerk.
TurningRows rows_at(const Segment& segment, int instant, const Vec3& force, const Vec3& jerk, double share,
                    double limit) {
  TurningRows rows;
  const double norm = length(force);
  rows.thrust = norm > 0.0 ? (1.0 / norm) * force : kUp;
  rows.turn = turn_of(jerk, rows.thrust);
  const double rate = norm > 0.0 ? dot(jerk, rows.turn) / norm : kUnlimited;
  const double excess = clamp(rate / limit, kLeastRate, kMostRate);
  // Between the thrust that the plan's jerk needs and the thrust that it has: jerk and thrust may change by as much.
  const double thrust = square_root(excess) * share * norm;
  const double allowed = kJerkShare * limit * thrust;
  const double least = least_thrust(segment, instant, rows.thrust);
  const Vec3 own = (1.0 / power_of(segment.duration, 3)) * point_of(segment, kHodographPoints.jerk[instant]);
  rows.least = smaller(thrust, larger(1.0, share) * least);
  rows.most = larger(allowed, smaller(1.0, share) * dot(own, rows.turn));
  rows.side = larger(allowed, absolute(dot(own, cross(rows.thrust, rows.turn))));
  return rows;
}

}  // namespace

void first_turning(const Chain& chain, const MotionLimits& limits, Turning& turning) noexcept {
  const double jerk = limits.rate * kGravity;
  const double thrust = larger(kFirstThrust * kGravity, kGravity + limits.acceleration.lower.z);
  for (int i = 0; i < chain.count; ++i) {
    for (TurningRows& rows : turning.rows[i]) rows = {kUp, {1.0, 0.0, 0.0}, thrust, jerk, jerk};
    for (double& share : turning.share[i]) share = 1.0;
  }
  allow_ends(chain, limits, turning);
}

void follow_turning(const Candidate& plan, const MotionLimits& limits, Turning& turning) noexcept {
  for (int i = 0; i < plan.chain.count; ++i) {
    const Segment segment = segment_of(plan, i);
    const Curve acceleration = hodograph(hodograph(curve_of(segment), segment.duration), segment.duration);
    const Curve jerk = hodograph(acceleration, segment.duration);
    for (int r = 0; r < kJerkPoints; ++r) {
      const double u = static_cast<double>(r) / (kJerkPoints - 1);
      const Vec3 force = value(acceleration, u) + kGravity * kUp;
      turning.rows[i][r] = rows_at(segment, r, force, value(jerk, u), turning.share[i][r], limits.rate);
    }
  }
  allow_ends(plan.chain, limits, turning);
}

}  // namespace tern
