// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "yaw_piece.hpp"

namespace tern {
namespace {

/// The Bernstein polynomials of degree 7 at u = 1/3, times 3^7. At 2/3 they stand in reverse order.
constexpr double kThird[kControlPoints] = {128.0, 448.0, 672.0, 560.0, 280.0, 84.0, 14.0, 1.0};
constexpr double kWhole = 2187.0;

struct EndPoints {
  double first, second, third;  ///< from the end inwards
};

/// The three control points at one end of the piece; `inwards` is 1 at the beginning and -1 at the end.
EndPoints end_points(const YawSample& sample, double duration, double inwards) {
  const double step = inwards * sample.yaw.rate * duration / kDegree;
  const double bend = sample.acceleration * duration * duration / (kDegree * (kDegree - 1));
  return {sample.angle, sample.angle + step, sample.angle + 2.0 * step + bend};
}

/// What the two middle control points must add to the angle, times 3^7, at a third of the way or at two thirds.
double missing(const double* points, bool at_third, double angle) {
  double sum = kWhole * angle;
  for (int i = 0; i < kControlPoints; ++i) {
    const bool middle = i == 3 || i == 4;
    if (!middle) sum -= (at_third ? kThird[i] : kThird[kDegree - i]) * points[i];
  }
  return sum;
}

}  // namespace

void yaw_piece(const YawPlan* plan, double begin, double duration, double (&points)[kControlPoints]) noexcept {
  for (double& point : points) point = 0.0;
  if (plan == nullptr) return;
  const EndPoints from = end_points(evaluate(*plan, begin), duration, 1.0);
  const EndPoints to = end_points(evaluate(*plan, begin + duration), duration, -1.0);
  points[0] = from.first;
  points[1] = from.second;
  points[2] = from.third;
  points[5] = to.third;
  points[6] = to.second;
  points[7] = to.first;
  const double a = missing(points, true, evaluate(*plan, begin + duration / 3.0).angle);
  const double b = missing(points, false, evaluate(*plan, begin + 2.0 * duration / 3.0).angle);
  // 560 p3 + 280 p4 = a, 280 p3 + 560 p4 = b.
  points[3] = (2.0 * a - b) / 840.0;
  points[4] = (2.0 * b - a) / 840.0;
}

}  // namespace tern
