// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tilt and body rates for all t. Both compare squares, which are polynomials: |(x, y)|^2 with (slope z)^2 of the
// thrust, and |jerk x thrust|^2 with rate^2 |thrust|^4. The margin is the difference, scaled to the unit of the limit
// at the hover's thrust. What is granted is part of the comparison.
#include <algorithm>

#include "verify/proofs.hpp"

namespace tern_verify {
namespace {

/// Bernstein coefficients of one number.
using Scalar = std::vector<Rational>;

/// Halvings after which a piece counts with its coefficients.
constexpr int kMostHalvings = 40;

Integer choose(std::size_t n, std::size_t k) {
  Integer product = 1;
  for (std::size_t i = 1; i <= k; ++i) product = product * (n - k + i) / i;
  return product;
}

Scalar operator*(const Scalar& a, const Scalar& b) {
  const std::size_t m = a.size() - 1;
  const std::size_t n = b.size() - 1;
  Scalar product(m + n + 1, Rational(0));
  for (std::size_t i = 0; i <= m; ++i) {
    for (std::size_t k = 0; k <= n; ++k) {
      product[i + k] += Rational(choose(m, i) * choose(n, k)) / Rational(choose(m + n, i + k)) * a[i] * b[k];
    }
  }
  return product;
}

Scalar combined(const Scalar& a, const Rational& factor, const Scalar& b) {
  Scalar sum = a;
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += factor * b[i];
  return sum;
}

Scalar component(const Polygon<3>& curve, std::size_t axis) {
  Scalar result;
  for (const Point& point : curve) result.push_back(point[axis]);
  return result;
}

/// Thrust and jerk of a segment.
struct Motion {
  Scalar f[3];
  Scalar j[3];
};

Motion motion_of(const Segment& segment) {
  Polygon<3> curve = hodograph(hodograph(segment.points, segment.duration), segment.duration);
  Motion motion;
  for (std::size_t a = 0; a < 3; ++a) motion.f[a] = component(curve, a);
  for (Rational& z : motion.f[2]) z += gravity();
  curve = hodograph(curve, segment.duration);
  for (std::size_t a = 0; a < 3; ++a) motion.j[a] = component(curve, a);
  return motion;
}

/// Above 0 where the tilt is beyond its limit.
Scalar tilt_excess(const Segment& segment, const Rational& slope) {
  const Motion motion = motion_of(segment);
  Scalar vertical = motion.f[2];
  for (Rational& z : vertical) z += tilt_tolerance(segment, slope);
  const Scalar flat = combined(motion.f[0] * motion.f[0], 1, motion.f[1] * motion.f[1]);
  Scalar excess = combined(flat, -slope * slope, vertical * vertical);
  for (Rational& x : excess) x /= 2 * slope * gravity();
  return excess;
}

/// Above 0 where the thrust turns faster than its limit.
Scalar turn_excess(const Segment& segment, const Rational& rate, const Rational& least_thrust) {
  const Motion motion = motion_of(segment);
  Scalar turns;
  Scalar thrust;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3;
    const std::size_t c = (a + 2) % 3;
    const Scalar cross = combined(motion.j[b] * motion.f[c], -1, motion.j[c] * motion.f[b]);
    turns = a == 0 ? cross * cross : combined(turns, 1, cross * cross);
    const Scalar square = motion.f[a] * motion.f[a];
    thrust = a == 0 ? square : combined(thrust, 1, square);
  }
  const Rational most = rate + turn_tolerance(segment, rate, least_thrust);
  const Scalar raised = turns * Scalar(3, Rational(1));  // the same polynomial, with as many coefficients
  Scalar excess = combined(raised, -most * most, thrust * thrust);
  const Rational hover = gravity() * gravity();
  for (Rational& x : excess) x /= 2 * rate * hover * hover;
  return excess;
}

/// The largest value of a polynomial, if it is above `reached`, to within a part in 10^13 of the unit.
class Highest {
 public:
  explicit Highest(Rational reached) : reached_(std::move(reached)), bound_(reached_) {}

  void search(const Polygon<1>& curve, const Rational& begin, const Rational& width, int halvings) {
    Rational hull = curve.front()[0];
    for (const auto& point : curve) hull = std::max(hull, point[0]);
    reach(curve.front()[0], begin);
    reach(curve.back()[0], begin + width);
    if (hull <= reached_ + decimal(1, 13) || halvings == kMostHalvings) {
      bound_ = std::max(bound_, hull);
      return;
    }
    const Halves<1> halves = halves_of(curve);
    search(halves.left, begin, width / 2, halvings + 1);
    search(halves.right, begin + width / 2, width / 2, halvings + 1);
  }

  bool found = false;
  Rational u = 0;
  const Rational& reached() const { return reached_; }
  const Rational& bound() const { return bound_; }

 private:
  void reach(const Rational& value, const Rational& at) {
    if (value <= reached_) return;
    found = true;
    reached_ = value;
    u = at;
    bound_ = std::max(bound_, value);
  }

  Rational reached_;
  Rational bound_;
};

void note(const std::vector<Segment>& segments, std::size_t s, const Scalar& excess, Claim& claim) {
  Polygon<1> curve;
  for (const Rational& x : excess) curve.push_back({x});
  Highest highest(s == 0 ? Rational(excess.front() - 1) : Rational(-claim.most));
  highest.search(curve, 0, 1, 0);
  if (s > 0) claim.least = std::min<Rational>(claim.least, -highest.bound());
  if (!highest.found) return;
  claim.most = -highest.reached();
  if (s == 0) claim.least = -highest.bound();
  claim.place = place_of(segments, s, highest.u);
}

}  // namespace

void prove_turns(const std::vector<Segment>& segments, const std::vector<Bound>& bounds, Claims& claims) {
  Rational least_thrust = 0;
  for (const Bound& bound : bounds) {
    const bool is_fall = bound.derivative == 2 && bound.axis == 2 && bound.sign < 0;
    if (is_fall) least_thrust = gravity() - bound.most;
    if (bound.axis != kTilt && bound.axis != kTurn) continue;
    if (bound.axis == kTurn && least_thrust <= 0) throw InputError("a limit on body rates needs a 'thrust_min'");
    Claim claim;
    claim.what = bound.axis == kTilt ? "tilt" : "body rate";
    claim.unit = bound.axis == kTilt ? "m/s2" : "rad/s";
    for (std::size_t s = 0; s < segments.size(); ++s) {
      const Scalar excess = bound.axis == kTilt ? tilt_excess(segments[s], bound.most)
                                                : turn_excess(segments[s], bound.most, least_thrust);
      note(segments, s, excess, claim);
    }
    claims.push_back(claim);
  }
}

}  // namespace tern_verify
