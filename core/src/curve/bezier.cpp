// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "curve/bezier.hpp"

namespace tern {
namespace {

/// The integral over u in [0, 1] of the product of the cubic Bernstein polynomials i and j.
constexpr double kCubicGram[4][4] = {{1.0 / 7.0, 1.0 / 14.0, 1.0 / 35.0, 1.0 / 140.0},
                                     {1.0 / 14.0, 3.0 / 35.0, 9.0 / 140.0, 1.0 / 35.0},
                                     {1.0 / 35.0, 9.0 / 140.0, 3.0 / 35.0, 1.0 / 14.0},
                                     {1.0 / 140.0, 1.0 / 35.0, 1.0 / 14.0, 1.0 / 7.0}};

Vec3 blend(const Vec3& a, const Vec3& b, double u) {
  return (1.0 - u) * a + u * b;
}

/// The largest gauge of the control points between the two ends.
double hull_between(const Curve& curve, const Bounds& bounds) {
  double result = 0.0;
  for (int i = 1; i < curve.degree; ++i) result = larger(result, gauge(bounds, curve.c[i]));
  return result;
}

/// Pieces that are still to be examined, the deepest on top. Each level of halving leaves at most one piece waiting.
struct Pieces {
  Curve curve[kPeakDepth + 1];
  int depth[kPeakDepth + 1];
  int count;
};

/// Makes the curve its own hodograph.
void differentiate(Curve& curve, double duration) {
  const double factor = curve.degree / duration;
  for (int i = 0; i < curve.degree; ++i) curve.c[i] = factor * (curve.c[i + 1] - curve.c[i]);
  --curve.degree;
}

void push(Pieces& pieces, const Curve& curve, int depth) {
  pieces.curve[pieces.count] = curve;
  pieces.depth[pieces.count] = depth;
  ++pieces.count;
}

}  // namespace

Curve curve_of(const Segment& segment) noexcept {
  Curve curve;
  curve.degree = kDegree;
  for (int i = 0; i <= kDegree; ++i) curve.c[i] = segment.points[i];
  return curve;
}

Curve hodograph(const Curve& curve, double duration) noexcept {
  Curve result;
  result.degree = curve.degree - 1;
  const double factor = curve.degree / duration;
  for (int i = 0; i < curve.degree; ++i) result.c[i] = factor * (curve.c[i + 1] - curve.c[i]);
  return result;
}

Curve snap_of(const Segment& segment) noexcept {
  Curve curve = curve_of(segment);
  for (int k = 0; k < 4; ++k) differentiate(curve, segment.duration);
  return curve;
}

double integral_of_product(const Curve& a, const Curve& b, double duration) noexcept {
  double sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) sum += kCubicGram[i][j] * dot(a.c[i], b.c[j]);
  }
  return duration * sum;
}

Vec3 value(Curve curve, double u) noexcept {
  for (int level = curve.degree; level > 0; --level) {
    for (int i = 0; i < level; ++i) curve.c[i] = blend(curve.c[i], curve.c[i + 1], u);
  }
  return curve.c[0];
}

Curve split(Curve& curve) noexcept {
  const int n = curve.degree;
  Curve second;
  second.degree = n;
  for (int level = 0; level <= n; ++level) {
    second.c[n - level] = curve.c[n];
    for (int i = n; i > level; --i) curve.c[i] = 0.5 * (curve.c[i - 1] + curve.c[i]);
  }
  return second;
}

// The ends of all pieces are values of the curve, and `lower` already covers them. So a piece's hull needs only the
// control points between its ends, and a cut adds one value: the point where the halves meet.
double peak_bound(const Curve& curve, const Bounds& bounds, double floor, double tolerance) noexcept {
  double lower = larger(gauge(bounds, curve.c[0]), gauge(bounds, curve.c[curve.degree]));
  double bound = larger(lower, floor);
  Pieces pieces;
  pieces.count = 0;
  push(pieces, curve, 0);
  for (int step = 0; step < kPeakPieces && pieces.count > 0; ++step) {
    Curve& piece = pieces.curve[pieces.count - 1];
    int& depth = pieces.depth[pieces.count - 1];
    const double top = hull_between(piece, bounds);
    if (top <= larger(floor, lower * (1.0 + tolerance)) || depth == kPeakDepth) {
      bound = larger(bound, top);
      --pieces.count;
      continue;
    }
    Curve first = piece;
    piece = split(first);
    lower = larger(lower, gauge(bounds, piece.c[0]));
    bound = larger(bound, lower);
    ++depth;
    push(pieces, first, depth);
  }
  for (int i = 0; i < pieces.count; ++i) bound = larger(bound, hull_between(pieces.curve[i], bounds));
  return bound;
}

}  // namespace tern
