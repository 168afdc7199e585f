// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/curve_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "host/flight/vectors.hpp"
#include "host/nanoseconds.hpp"
#include "tern/flatness.hpp"

namespace tern_host {
namespace {

using tern::Vec3;

constexpr double kLimitExcess = 1e-6;            // relative
constexpr double kLooseRate = 1.01;              // of a body rate's bound over a piece
constexpr std::int64_t kJointNanoseconds = 100;  // stretches with a joint are halved down to this
// Rounding of positions, of which the derivatives of a short piece are quotients: times 7, 42 and 210. Metres.
constexpr std::array<double, 4> kSliverRounding{1e-14, 1e-13, 1e-12, 4e-12};
constexpr double kFitPosition = 1e-12;     // rounding of what a piece leads to: m, and parts of the position,
constexpr double kFitVelocity = 1e-10;     // m/s,
constexpr double kFitJerk = 1e-6;          // m/s^3,
constexpr double kFitAcceleration = 1e-9;  // and m/s^2, of which the jerk is a quotient

/// a + k b.
Vec3 plus(const Vec3& a, double k, const Vec3& b) {
  return {a.x + k * b.x, a.y + k * b.y, a.z + k * b.z};
}

Vec3 off(const Vec3& a, const Vec3& b) {
  return plus(a, -1.0, b);
}

double seconds(const TimedSample& a, const TimedSample& b) {
  return seconds_of(b.t - a.t);
}

/// De Casteljau.
Vec3 jerk_at(const PieceHull& hull, double u) {
  std::array<Vec3, 5> c = hull.jerk;
  for (std::size_t left = c.size() - 1; left > 0; --left) {
    for (std::size_t i = 0; i < left; ++i) c[i] = plus(c[i], u, off(c[i + 1], c[i]));
  }
  return c[0];
}

const char* beyond(const tern::Limits& l, const Vec3& v) {
  const double wider = 1.0 + kLimitExcess;
  const bool within = std::hypot(v.x, v.y) <= wider * l.v_horizontal && std::abs(v.z) <= wider * l.v_max.z;
  return within ? nullptr : "is faster than its limit";
}

const char* beyond_acceleration(const tern::Limits& l, const Vec3& a) {
  const double wider = 1.0 + kLimitExcess;
  const double lowest = l.a_min.z < 0.0 ? l.a_min.z : -l.a_max.z;
  const bool within =
      std::hypot(a.x, a.y) <= wider * l.a_horizontal && a.z <= wider * l.a_max.z && a.z >= wider * lowest;
  return within ? nullptr : "accelerates beyond its limit";
}

Vec3 thrust_at(const Vec3& a) {
  return {a.x, a.y, a.z + tern::kGravity};
}

const char* beyond_thrust(const tern::Limits& l, const Vec3& a) {
  const Vec3 f = thrust_at(a);
  const double granted = kLimitExcess * tern::kGravity;
  if (l.thrust_max > 0.0 && length(f) > (1.0 + kLimitExcess) * l.thrust_max + granted) return "thrusts too much";
  if (l.thrust_min > 0.0 && f.z < l.thrust_min - granted) return "thrusts too little";
  const bool tilts = l.tilt_tangent > 0.0 && std::hypot(f.x, f.y) > l.tilt_tangent * (f.z + granted);
  return tilts ? "tilts beyond its limit" : nullptr;
}

/// The body rate times the squared thrust.
double turn(const Vec3& j, const Vec3& f) {
  return length({j.y * f.z - j.z * f.y, j.z * f.x - j.x * f.z, j.x * f.y - j.y * f.x});
}

const char* beyond_rate(const tern::Limits& l, const tern::Sample& sample) {
  const Vec3 f = thrust_at(sample.acceleration);
  const double most = (1.0 + kLimitExcess) * l.rate_max * (f.x * f.x + f.y * f.y + f.z * f.z);
  return l.rate_max > 0.0 && turn(sample.jerk, f) > most ? "turns beyond its limit" : nullptr;
}

/// Bounds the rate over a piece by its largest products and its least thrust, which is no tight bound.
const char* beyond_rate(const tern::Limits& l, const PieceHull& hull) {
  if (!(l.rate_max > 0.0)) return nullptr;
  const Vec3 along = thrust_at(hull.acceleration.front());
  double least = length(along);
  double most = 0.0;
  for (const Vec3& a : hull.acceleration) {
    const Vec3 f = thrust_at(a);
    least = std::min(least, (f.x * along.x + f.y * along.y + f.z * along.z) / length(along));
    for (const Vec3& j : hull.jerk) most = std::max(most, turn(j, f));
  }
  const bool within = least > 0.0 && most <= kLooseRate * l.rate_max * least * least;
  return within ? nullptr : "turns beyond its limit";
}

const char* beyond_jerk(const tern::Limits& l, const Vec3& j) {
  const double most = std::max({std::abs(j.x), std::abs(j.y), std::abs(j.z)});
  return l.j_max.x > 0.0 && most > (1.0 + kLimitExcess) * l.j_max.x ? "jerks beyond its limit" : nullptr;
}

/// How much larger than they may be the differences are between two samples: of position, velocity, acceleration and
/// jerk, in this order. Negative where a difference may be.
using Steps = std::array<double, 4>;

Steps steps_between(const TimedSample& a, const TimedSample& b) {
  const double h = seconds(a, b);
  const tern::Sample& p = a.sample;
  const tern::Sample& q = b.sample;
  const double jerk = std::max(length(p.jerk), length(q.jerk));
  const double snap = std::max(length(p.snap), length(q.snap));
  const Vec3 position = plus(plus(p.position, h, p.velocity), 0.5 * h * h, p.acceleration);
  const JointRounding& r = kJointRounding;
  return {length(off(q.position, position)) - h * h * h * jerk - r.position * (1.0 + length(q.position)),
          length(off(q.velocity, plus(p.velocity, h, p.acceleration))) - h * h * jerk - r.velocity,
          length(off(q.acceleration, plus(p.acceleration, h, p.jerk))) - 2.0 * h * h * snap - r.acceleration,
          length(off(q.jerk, p.jerk)) - 2.0 * h * snap - r.jerk};
}

/// A sample h seconds away, with the derivatives that are known.
tern::Sample moved(const tern::Sample& s, double h) {
  tern::Sample to = s;
  to.jerk = plus(s.jerk, h, s.snap);
  to.acceleration = plus(plus(s.acceleration, h, s.jerk), h * h / 2.0, s.snap);
  to.velocity = plus(plus(plus(s.velocity, h, s.acceleration), h * h / 2.0, s.jerk), h * h * h / 6.0, s.snap);
  to.position = plus(plus(plus(plus(s.position, h, s.velocity), h * h / 2.0, s.acceleration), h * h * h / 6.0, s.jerk),
                     h * h * h * h / 24.0, s.snap);
  return to;
}

/// The motion `w` seconds before an instant leads to the motion as long behind it, if what the snap does between is
/// left open.
bool sides_agree(const Commands& commands, std::int64_t t, double w) {
  const auto away = static_cast<std::int64_t>(1e9 * w);
  const tern::Sample before = commands(t - away);
  const tern::Sample behind = commands(t + away);
  const tern::Sample p = moved(before, w);
  const tern::Sample q = moved(behind, -w);
  const double snap = length(before.snap) + length(behind.snap);
  const JointRounding& r = kJointRounding;
  return length(off(p.position, q.position)) <= w * w * w * w * snap / 12.0 + r.position * (1.0 + length(p.position)) &&
         length(off(p.velocity, q.velocity)) <= w * w * w * snap / 3.0 + r.velocity &&
         length(off(p.acceleration, q.acceleration)) <= w * w * snap + r.acceleration &&
         length(off(p.jerk, q.jerk)) <= 2.0 * w * snap + r.jerk;
}

/// The steps are rounding of a piece that is shorter than one of some durations, and both its sides agree. The k-th
/// derivative of a short piece is a quotient of rounded positions and its duration to the power of k.
bool is_sliver(const Commands& commands, std::int64_t t, const Steps& steps) {
  for (const double w : {2e-5, 1e-4, 5e-4, 2e-3}) {
    const std::array<double, 4>& r = kSliverRounding;
    const bool is_rounding =
        steps[0] <= r[0] && steps[1] * w <= r[1] && steps[2] * w * w <= r[2] && steps[3] * w * w * w <= r[3];
    if (is_rounding && sides_agree(commands, t, w)) return true;
  }
  return false;
}

}  // namespace

/// The acceleration is of degree 5, which value, first and second derivative at both ends determine. Its coefficients
/// add up to the velocity's, and those to the position.
bool single_piece(const TimedSample& first, const TimedSample& middle, const TimedSample& last, PieceHull& hull) {
  const double h = seconds(first, last);
  const tern::Sample& p = first.sample;
  const tern::Sample& q = last.sample;
  auto& a = hull.acceleration;
  a = {p.acceleration,
       plus(p.acceleration, h / 5.0, p.jerk),
       plus(plus(p.acceleration, 2.0 * h / 5.0, p.jerk), h * h / 20.0, p.snap),
       plus(plus(q.acceleration, -2.0 * h / 5.0, q.jerk), h * h / 20.0, q.snap),
       plus(q.acceleration, -h / 5.0, q.jerk),
       q.acceleration};
  for (std::size_t i = 0; i < hull.jerk.size(); ++i) hull.jerk[i] = plus({}, 5.0 / h, off(a[i + 1], a[i]));
  hull.velocity[0] = p.velocity;
  for (std::size_t i = 0; i < a.size(); ++i) hull.velocity[i + 1] = plus(hull.velocity[i], h / 6.0, a[i]);
  Vec3 end = p.position;
  for (const Vec3& velocity : hull.velocity) end = plus(end, h / 7.0, velocity);
  return length(off(hull.velocity.back(), q.velocity)) <= kFitVelocity &&
         length(off(end, q.position)) <= kFitPosition * (1.0 + length(q.position)) + h * kFitVelocity &&
         length(off(jerk_at(hull, seconds(first, middle) / h), middle.sample.jerk)) <= kFitJerk + kFitAcceleration / h;
}

bool is_continuous(const TimedSample& a, const TimedSample& b) {
  const Steps steps = steps_between(a, b);
  return std::all_of(steps.begin(), steps.end(), [](double step) { return step <= 0.0; });
}

const char* broken_limit(const tern::Limits& limits, const PieceHull& hull) {
  for (const Vec3& v : hull.velocity) {
    if (beyond(limits, v) != nullptr) return beyond(limits, v);
  }
  for (const Vec3& a : hull.acceleration) {
    if (beyond_acceleration(limits, a) != nullptr) return beyond_acceleration(limits, a);
    if (beyond_thrust(limits, a) != nullptr) return beyond_thrust(limits, a);
  }
  for (const Vec3& j : hull.jerk) {
    if (beyond_jerk(limits, j) != nullptr) return beyond_jerk(limits, j);
  }
  return beyond_rate(limits, hull);
}

const char* broken_limit(const tern::Limits& limits, const tern::Sample& sample) {
  if (const char* const fast = beyond(limits, sample.velocity)) return fast;
  if (const char* const sharp = beyond_acceleration(limits, sample.acceleration)) return sharp;
  if (const char* const thrust = beyond_thrust(limits, sample.acceleration)) return thrust;
  if (const char* const turns = beyond_rate(limits, sample)) return turns;
  return beyond_jerk(limits, sample.jerk);
}

/// Stretches that are one piece and keep the limits with their hull are done with. All others are halved: hulls of
/// shorter ones lie closer to the curve, and a joint is looked at from both its sides.
void CurveCheck::look(const TimedSample& a, const TimedSample& b) {
  snap_ = std::max({snap_, length(a.sample.snap), length(b.sample.snap)});
  if (fault_.what != nullptr) return;
  if (b.t - a.t <= kJointNanoseconds) return look_at_joint(a, b);
  const std::int64_t middle = a.t + (b.t - a.t) / 2;
  const TimedSample m{middle, commands_(middle)};
  PieceHull hull;
  if (single_piece(a, m, b, hull) && broken_limit(limits_, hull) == nullptr) return;
  look(a, m);
  look(m, b);
}

void CurveCheck::look_at_joint(const TimedSample& a, const TimedSample& b) {
  const Steps steps = steps_between(a, b);
  const bool continuous = is_continuous(a, b);
  if (!continuous && !is_sliver(commands_, a.t, steps)) {
    fault_ = {"is not smooth", false, a.t};
  } else if (!continuous) {
    ++slivers_;
  } else if (const char* const broken = broken_limit(limits_, b.sample)) {
    fault_ = {broken, true, b.t};
  }
}

}  // namespace tern_host
