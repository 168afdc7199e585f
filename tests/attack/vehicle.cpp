// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The checker's rules on the vehicle's own limits: thrust, tilt and body rates for all t. Thrust and tilt are convex
// rules. The rate is compared at the ends of pieces, and between them by a bound of the second derivative.
#include <algorithm>
#include <cmath>

#include "attack/checker.hpp"
#include "tern/flatness.hpp"

namespace tern_attack {
namespace {

constexpr Real kGravity = tern::kGravity;
constexpr int kMostPieces = 2000000;

Point thrust_of(const Point& acceleration) {
  return {{acceleration[0], acceleration[1], acceleration[2] + kGravity}};
}

/// The largest norm of the coefficients, which bounds the curve.
Real most_of(const Curve& curve) {
  Real most = 0;
  for (int i = 0; i <= curve.degree; ++i) most = std::max(most, length(curve.p[i]));
  return most;
}

/// Thrust and its derivatives, over the same piece.
struct Motion {
  Curve d[4];
};

/// rate^2 |f|^4 - |j x f|^2 at one end of a piece.
Real room_at(const Point& f, const Point& j, Real rate) {
  const Point turn = cross(j, f);
  const Real square = f[0] * f[0] + f[1] * f[1] + f[2] * f[2];
  return rate * rate * square * square - (turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2]);
}

/// A bound of the second derivative by time of the room.
Real most_bent(const Motion& motion, Real rate) {
  Real f[4];
  for (int k = 0; k < 4; ++k) f[k] = most_of(motion.d[k]);
  const Real square1 = 2 * f[0] * f[1];
  const Real square2 = 2 * (f[1] * f[1] + f[0] * f[2]);
  const Real quartic = 2 * (square1 * square1 + f[0] * f[0] * square2);
  const Real turn = f[1] * f[0];  // the derivative of f x f' is f x f''
  const Real turn1 = f[0] * f[2];
  const Real turn2 = f[1] * f[2] + f[0] * f[3];
  return rate * rate * quartic + 2 * (turn1 * turn1 + turn * turn2);
}

void check_rate(const tern::Segment& segment, const Curve& acceleration, const tern::Limits& limits, int s,
                Findings& findings) {
  const Real rounding_of_rate = (2 * rounding(segment, 3) + 4 * limits.rate_max * rounding(segment, 2)) * kLimitUlps;
  const Real rate = limits.rate_max * (1 + kLimitSlack) + rounding_of_rate / limits.thrust_min;
  Motion whole;
  whole.d[0] = acceleration;
  for (int i = 0; i <= acceleration.degree; ++i) whole.d[0].p[i] = thrust_of(acceleration.p[i]);
  for (int k = 1; k < 4; ++k) whole.d[k] = derivative(whole.d[k - 1], segment.duration);
  std::vector<Motion> open{whole};
  for (int pieces = 0; !open.empty(); ++pieces) {
    const Motion piece = open.back();
    open.pop_back();
    const Curve& f = piece.d[0];
    const Real ends =
        std::min(room_at(f.first(), piece.d[1].first(), rate), room_at(f.last(), piece.d[1].last(), rate));
    const Real seconds = (f.to - f.from) * segment.duration;
    if (ends < 0) return report(findings, "body_rate", "segment %d u %.17Lg: beyond %.17g", s, f.from, limits.rate_max);
    if (ends >= seconds * seconds / 8 * most_bent(piece, rate)) continue;
    if (pieces == kMostPieces) return report(findings, "body_rate", "segment %d u %.17Lg: not decided", s, f.from);
    Motion left;
    Motion right;
    for (int k = 0; k < 4; ++k) split(piece.d[k], left.d[k], right.d[k]);
    open.push_back(right);
    open.push_back(left);
  }
}

}  // namespace

bool keeps_vehicle(const tern::Limits& limits, const Point& acceleration, Real excess, Real rounding) {
  const Point f = thrust_of(acceleration);
  const Real spare = excess * kGravity + 2 * rounding;
  const bool limited = limits.thrust_max > 0.0 || limits.thrust_min > 0.0 || limits.tilt_tangent > 0.0;
  if (limits.thrust_max > 0.0 && length(f) > limits.thrust_max * (1 + excess) + spare) return false;
  if (limited && f[2] < limits.thrust_min - spare) return false;
  const Real lifted = f[2] + spare + (limits.tilt_tangent > 0.0 ? 2 * rounding / limits.tilt_tangent : 0);
  return !(limits.tilt_tangent > 0.0) || std::hypot(f[0], f[1]) <= limits.tilt_tangent * lifted;
}

bool turns_slowly(const tern::Limits& limits, const Point& acceleration, const Point& jerk) {
  return !(limits.rate_max > 0.0) || room_at(thrust_of(acceleration), jerk, limits.rate_max) >= 0;
}

void check_vehicle(const tern::Request& request, const tern::Trajectory& trajectory, Findings& findings) {
  const tern::Limits& limits = request.limits;
  const std::size_t before = findings.size();
  for (int s = 0; s < trajectory.count && findings.size() == before; ++s) {
    const tern::Segment& segment = trajectory.segments[s];
    const Curve velocity = derivative(curve_of(segment.points), segment.duration);
    const Curve acceleration = derivative(velocity, segment.duration);
    const Real slack = kLimitUlps * rounding(segment, 2);
    const Verdict verdict =
        prove(acceleration, [&](const Point& a) { return keeps_vehicle(limits, a, kLimitSlack, slack); });
    if (verdict.proof != Proof::kProven) {
      const Point a = value(acceleration, verdict.where);
      report(findings, "thrust", "segment %d u %.17Lg: a (%.17Lg, %.17Lg, %.17Lg)", s, verdict.where, a[0], a[1], a[2]);
    }
    if (limits.rate_max > 0.0) check_rate(segment, acceleration, limits, s, findings);
  }
}

}  // namespace tern_attack
