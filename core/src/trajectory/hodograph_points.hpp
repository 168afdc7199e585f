// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The points that a limit applies to: control points of pieces of a hodograph. The control points of the whole
// hodograph bound it (its hull), but by up to a third too much; those of its two halves are four times closer. The
// weights of the eight control points of the position in each point are constants.
#ifndef TERN_TRAJECTORY_HODOGRAPH_POINTS_HPP
#define TERN_TRAJECTORY_HODOGRAPH_POINTS_HPP

#include "tern/trajectory.hpp"

namespace tern {

/// Equal pieces that the hodographs are cut into: 1, 2 or 4. An acceleration varies more within a segment than a
/// velocity. A jerk also varies more, but its hull is closer, since its degree is only 4.
constexpr int kVelocityPieces = 2;
constexpr int kAccelerationPieces = 4;
constexpr int kJerkPieces = 2;
/// Control points of all pieces, shared ends counted once.
constexpr int kVelocityPoints = 6 * kVelocityPieces + 1;
constexpr int kAccelerationPoints = 5 * kAccelerationPieces + 1;
constexpr int kJerkPoints = 4 * kJerkPieces + 1;

/// Entry r has the weights of control points 0 .. 7, still to be divided by duration^order. They are dyadic numbers, so
/// they are exact.
struct HodographPoints {
  double velocity[kVelocityPoints][kControlPoints];
  double acceleration[kAccelerationPoints][kControlPoints];
  double jerk[kJerkPoints][kControlPoints];
};

/// The control points of one curve, each as weights of the position's eight control points.
struct WeightedCurve {
  double w[kControlPoints][kControlPoints];
  int degree;
};

constexpr WeightedCurve derivative_weights(int order) {
  WeightedCurve curve{};
  curve.degree = kDegree;
  for (int i = 0; i <= kDegree; ++i) curve.w[i][i] = 1.0;
  for (int k = 0; k < order; ++k) {
    const double factor = curve.degree;
    for (int i = 0; i < curve.degree; ++i) {
      for (int j = 0; j <= kDegree; ++j) curve.w[i][j] = factor * (curve.w[i + 1][j] - curve.w[i][j]);
    }
    --curve.degree;
  }
  return curve;
}

/// Cuts the curve at u by de Casteljau: `curve` becomes the part over [u, 1], and the part over [0, u] is returned.
constexpr WeightedCurve cut_weights(WeightedCurve& curve, double u) {
  const int n = curve.degree;
  WeightedCurve first{};
  first.degree = n;
  for (int level = 0; level <= n; ++level) {
    for (int j = 0; j <= kDegree; ++j) first.w[level][j] = curve.w[0][j];
    for (int i = 0; i < n - level; ++i) {
      for (int j = 0; j <= kDegree; ++j) curve.w[i][j] = (1.0 - u) * curve.w[i][j] + u * curve.w[i + 1][j];
    }
  }
  return first;
}

constexpr void piece_weights(int order, int pieces, double (*points)[kControlPoints]) {
  WeightedCurve rest = derivative_weights(order);
  const int n = rest.degree;
  for (int piece = 0; piece < pieces; ++piece) {
    const WeightedCurve first = cut_weights(rest, 1.0 / (pieces - piece));
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= kDegree; ++j) points[piece * n + i][j] = first.w[i][j];
    }
  }
}

constexpr HodographPoints make_hodograph_points() {
  HodographPoints points{};
  piece_weights(1, kVelocityPieces, points.velocity);
  piece_weights(2, kAccelerationPieces, points.acceleration);
  piece_weights(3, kJerkPieces, points.jerk);
  return points;
}

constexpr HodographPoints kHodographPoints = make_hodograph_points();

/// The points of a derivative, order 1 to 3.
struct OrderPoints {
  const double (*weights)[kControlPoints];
  int count;
};

constexpr OrderPoints points_of(int order) {
  if (order == 1) return {kHodographPoints.velocity, kVelocityPoints};
  if (order == 2) return {kHodographPoints.acceleration, kAccelerationPoints};
  return {kHodographPoints.jerk, kJerkPoints};
}

/// duration^order.
constexpr double power_of(double duration, int order) {
  double power = duration;
  for (int k = 1; k < order; ++k) power *= duration;
  return power;
}

}  // namespace tern

#endif
