// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Limits for all t, by a tree of halves: what bounds a hull bounds its curve, and the ends of a hull are on the curve.
#include <algorithm>

#include "verify/proofs.hpp"

namespace tern_verify {
namespace {

constexpr const char* kAxes[] = {"x", "y", "z", "horizontal", "thrust"};
/// Halvings after which a piece counts with its hull. A level takes three quarters of the hull's excess away.
constexpr int kMostHalvings = 40;

/// What is bounded, as a curve in N dimensions, and how large it is at a point: squared, where a root is not exact.
struct AlongAxis {
  static constexpr std::size_t kDimensions = 1;
  std::size_t axis;
  int sign;

  Vector<1> of(const Point& p) const { return {sign * p[axis]}; }
  static Rational size(const Vector<1>& v) { return v[0]; }
  static Rational size_of_value(const Rational& value) { return value; }
  static Rational value_below(const Rational& size) { return size; }
  static Rational value_above(const Rational& size) { return size; }
};

struct InPlane {
  static constexpr std::size_t kDimensions = 2;

  static Vector<2> of(const Point& p) { return {p[0], p[1]}; }
  static Rational size(const Vector<2>& v) { return dot(v, v); }
  /// No size is below that of a negative value.
  static Rational size_of_value(const Rational& value) { return value < 0 ? Rational(-1) : Rational(value * value); }
  static Rational value_below(const Rational& size) { return root_below(size); }
  static Rational value_above(const Rational& size) { return root_above(size); }
};

struct Thrust {
  static constexpr std::size_t kDimensions = 3;

  static Point of(const Point& p) { return {p[0], p[1], p[2] + gravity()}; }
  static Rational size(const Point& v) { return dot(v, v); }
  static Rational size_of_value(const Rational& value) { return InPlane::size_of_value(value); }
  static Rational value_below(const Rational& size) { return root_below(size); }
  static Rational value_above(const Rational& size) { return root_above(size); }
};

/// Searches for the largest size of one curve, if it is above `highest`, and tells it to within `close`.
template <typename Measure>
class Peak {
 public:
  using Curve = Polygon<Measure::kDimensions>;

  Peak(Rational highest, Rational close) : close_(std::move(close)), reached_(std::move(highest)), bound_(reached_) {}

  void search(const Curve& curve, const Rational& u, const Rational& width, int halvings) {
    Rational hull = Measure::size(curve.front());
    for (const auto& point : curve) hull = std::max(hull, Measure::size(point));
    reach(Measure::size(curve.front()), u);
    reach(Measure::size(curve.back()), u + width);
    if (hull <= (found_ ? Rational(reached_ + close_) : reached_) || halvings == kMostHalvings) {
      bound_ = std::max(bound_, hull);
      return;
    }
    const Halves<Measure::kDimensions> halves = halves_of(curve);
    search(halves.left, u, width / 2, halvings + 1);
    search(halves.right, u + width / 2, width / 2, halvings + 1);
  }

  bool is_higher() const { return bound_ > reached_ || found_; }
  const Rational& reached() const { return reached_; }  ///< by a point of the curve, or the size to be above
  const Rational& bound() const { return bound_; }      ///< no point has more
  const Rational& u() const { return u_; }              ///< of the point that reached most

 private:
  void reach(const Rational& size, const Rational& u) {
    if (size <= reached_) return;
    found_ = true;
    reached_ = size;
    u_ = u;
    bound_ = std::max(bound_, size);
  }

  Rational close_;
  Rational reached_;
  Rational bound_;
  Rational u_ = 0;
  bool found_ = false;
};

/// The claim becomes that of the segment with the least room, tolerance included.
template <typename Measure>
void prove_bound(const std::vector<Segment>& segments, const Bound& bound, const Measure& measure, Claim& claim) {
  const Rational close = Measure::size_of_value(bound.most) * decimal(1, 13);
  for (std::size_t s = 0; s < segments.size(); ++s) {
    Polygon<3> derivative = segments[s].points;
    for (int k = 0; k < bound.derivative; ++k) derivative = hodograph(derivative, segments[s].duration);
    Polygon<Measure::kDimensions> curve;
    for (const Point& point : derivative) curve.push_back(measure.of(point));
    const Rational tolerance = bound_tolerance(segments[s], bound);
    const Rational tightest = bound.most + tolerance - (claim.least + claim.tolerance);
    const Rational lowest = Measure::size(curve.front()) - 1;
    Peak<Measure> peak(s == 0 ? lowest : Measure::size_of_value(tightest), close);
    peak.search(curve, 0, 1, 0);
    if (!peak.is_higher()) continue;
    claim.most = bound.most - Measure::value_below(std::max<Rational>(peak.reached(), lowest));
    claim.least = bound.most - Measure::value_above(peak.bound());
    claim.tolerance = tolerance;
    claim.place = place_of(segments, s, peak.u());
  }
}

}  // namespace

void prove_bounds(const std::vector<Segment>& segments, const std::vector<Bound>& bounds, Claims& claims) {
  for (const Bound& bound : bounds) {
    if (bound.axis == kTilt || bound.axis == kTurn) continue;
    const std::string direction = bound.axis >= kHorizontal ? "" : (bound.sign > 0 ? "+" : "-");
    Claim claim;
    claim.what = kDerivativeNames[bound.derivative] + std::string(" ") + direction + kAxes[bound.axis];
    claim.unit = kUnits[bound.derivative];
    if (bound.axis == kHorizontal) {
      prove_bound(segments, bound, InPlane{}, claim);
    } else if (bound.axis == kThrust) {
      prove_bound(segments, bound, Thrust{}, claim);
    } else {
      prove_bound(segments, bound, AlongAxis{static_cast<std::size_t>(bound.axis), bound.sign}, claim);
    }
    claims.push_back(claim);
  }
}

}  // namespace tern_verify
