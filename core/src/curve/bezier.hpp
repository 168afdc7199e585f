// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Bezier curves (the paper's Section 3.4.1): the hodograph, subdivision, and exact bounds.
#ifndef TERN_CURVE_BEZIER_HPP
#define TERN_CURVE_BEZIER_HPP

#include "base/bounds.hpp"
#include "base/math.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// Bernstein coefficients c[0 .. degree] over u in [0, 1]. Coefficients beyond the degree have no meaning and are not
/// set: setting them would cost more than most operations on a curve.
struct Curve {
  Vec3 c[kControlPoints];
  int degree;
};

/// The position of a segment, metres over u = t / duration.
Curve curve_of(const Segment& segment) noexcept;

/// The derivative with respect to time of a curve that lasts `duration` seconds: one degree less (the hodograph
/// property). degree >= 1.
Curve hodograph(const Curve& curve, double duration) noexcept;

/// The fourth derivative of a segment's position: degree 3.
Curve snap_of(const Segment& segment) noexcept;

/// The integral over `duration` seconds of the scalar product of two cubics.
double integral_of_product(const Curve& a, const Curve& b, double duration) noexcept;

/// The value at u in [0, 1] by de Casteljau: convex combinations only, exact at both ends.
Vec3 value(Curve curve, double u) noexcept;

/// Cuts the curve at u = 1/2 by de Casteljau: `curve` becomes the first half over [0, 1], the second half is returned.
Curve split(Curve& curve) noexcept;

/// The control points [0 .. kDegree] of the part before u in (0, 1): by de Casteljau.
template <typename Point>
void keep_first_part(double u, Point* points) {
  for (int level = 1; level <= kDegree; ++level) {
    for (int k = kDegree; k >= level; --k) points[k] = (1.0 - u) * points[k - 1] + u * points[k];
  }
}

/// The control points [0 .. degree] of the part after u in [0, 1): by de Casteljau.
template <typename Point>
void keep_last_part(double u, Point* points, int degree = kDegree) {
  for (int level = 1; level <= degree; ++level) {
    for (int k = 0; k <= degree - level; ++k) points[k] = (1.0 - u) * points[k] + u * points[k + 1];
  }
}

/// A tight upper bound of the curve's gauge (see base/bounds.hpp) over [0, 1]. It is at least the supremum, and at most
/// the larger of `floor` and (1 + tolerance) * supremum. Values below a positive `floor` are not resolved: with
/// tolerance 0 the bound is exactly `floor` if the curve stays below it. Halves pieces until all hulls are close
/// enough. Each halving makes a hull's excess four times smaller. There are at most kPeakDepth halvings of a piece, and
/// kPeakPieces pieces. If these do not suffice, the hulls of the remaining pieces count, so the result stays a bound.
double peak_bound(const Curve& curve, const Bounds& bounds, double floor, double tolerance) noexcept;
constexpr int kPeakDepth = 16;
constexpr int kPeakPieces = 1024;

}  // namespace tern

#endif
