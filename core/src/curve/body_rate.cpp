// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "curve/body_rate.hpp"

#include "base/math.hpp"
#include "tern/flatness.hpp"

namespace tern {
namespace {

constexpr double kEndless = __builtin_inf();
constexpr int kThrust = kDegree - 2;  ///< degree of the thrust
constexpr int kJerk = kDegree - 3;    ///< degree of the jerk
constexpr int kSquare = 2 * kThrust;  ///< degree of the squared thrust
constexpr int kCross = kThrust + kJerk;

/// Binomial coefficients of the degrees above.
constexpr double kChooseJerk[kJerk + 1] = {1.0, 4.0, 6.0, 4.0, 1.0};
constexpr double kChooseThrust[kThrust + 1] = {1.0, 5.0, 10.0, 10.0, 5.0, 1.0};
constexpr double kChooseCross[kCross + 1] = {1.0, 9.0, 36.0, 84.0, 126.0, 126.0, 84.0, 36.0, 9.0, 1.0};
constexpr double kChooseSquare[kSquare + 1] = {1.0, 10.0, 45.0, 120.0, 210.0, 252.0, 210.0, 120.0, 45.0, 10.0, 1.0};

/// The control points of jerk x thrust, raised by one degree.
void cross_points(const Curve& jerk, const Curve& thrust, Vec3* points) {
  Vec3 low[kCross + 1] = {};
  for (int i = 0; i <= kJerk; ++i) {
    for (int k = 0; k <= kThrust; ++k) {
      const double weight = kChooseJerk[i] * kChooseThrust[k] / kChooseCross[i + k];
      low[i + k] = low[i + k] + weight * cross(jerk.c[i], thrust.c[k]);
    }
  }
  points[0] = low[0];
  points[kSquare] = low[kCross];
  for (int i = 1; i < kSquare; ++i) {
    const double part = static_cast<double>(i) / kSquare;
    points[i] = part * low[i - 1] + (1.0 - part) * low[i];
  }
}

void square_coefficients(const Curve& thrust, double* squares) {
  for (int i = 0; i <= kSquare; ++i) squares[i] = 0.0;
  for (int i = 0; i <= kThrust; ++i) {
    for (int k = 0; k <= kThrust; ++k) {
      squares[i + k] += kChooseThrust[i] * kChooseThrust[k] / kChooseSquare[i + k] * dot(thrust.c[i], thrust.c[k]);
    }
  }
}

/// The rate over a piece: its ends' exactly, and a bound between them. The cross product is within the hull of its
/// control points, and the square is a mean of its coefficients with the same weights.
struct Rates {
  double ends;
  double between;
};

Rates rates_of(const Curve& thrust, double duration) {
  Vec3 points[kSquare + 1];
  double squares[kSquare + 1];
  cross_points(hodograph(thrust, duration), thrust, points);
  square_coefficients(thrust, squares);
  Rates rates{0.0, 0.0};
  for (int i = 0; i <= kSquare; ++i) {
    const double rate = squares[i] > 0.0 ? length(points[i]) / squares[i] : kEndless;
    double& most = i == 0 || i == kSquare ? rates.ends : rates.between;
    most = larger(most, rate);
  }
  return rates;
}

/// The part of the curve over [begin, end] within [0, 1].
Curve part_of(Curve curve, double begin, double end) {
  for (int level = 1; level <= curve.degree; ++level) {
    for (int k = curve.degree; k >= level; --k) curve.c[k] = (1.0 - end) * curve.c[k - 1] + end * curve.c[k];
  }
  const double u = begin / end;
  for (int level = 1; level <= curve.degree; ++level) {
    for (int k = 0; k <= curve.degree - level; ++k) curve.c[k] = (1.0 - u) * curve.c[k] + u * curve.c[k + 1];
  }
  return curve;
}

}  // namespace

double body_rate(const Vec3& acceleration, const Vec3& jerk) noexcept {
  const Vec3 thrust = acceleration + Vec3{0.0, 0.0, kGravity};
  const double square = dot(thrust, thrust);
  return square > 0.0 ? length(cross(jerk, thrust)) / square : kEndless;
}

// Walks the pieces from left to right: piece `index` of 2^depth equal ones. No piece is stored.
double peak_rate(const Segment& segment, double floor, double tolerance) noexcept {
  Curve thrust = hodograph(hodograph(curve_of(segment), segment.duration), segment.duration);
  for (int i = 0; i <= kThrust; ++i) thrust.c[i].z += kGravity;
  double lower = 0.0;
  double bound = floor;
  double part = 1.0;
  int index = 0;
  int depth = 0;
  for (int step = 0; step < kRatePieces; ++step) {
    const Rates rates = rates_of(part_of(thrust, index * part, (index + 1) * part), part * segment.duration);
    lower = larger(lower, rates.ends);
    bound = larger(bound, lower);
    if (rates.between > larger(floor, lower * (1.0 + tolerance)) && depth < kRateDepth) {
      index *= 2;
      ++depth;
      part *= 0.5;
      continue;
    }
    bound = larger(bound, rates.between);
    for (++index; depth > 0 && index % 2 == 0; --depth) {
      index /= 2;
      part *= 2.0;
    }
    if (depth == 0) return bound;
  }
  return kEndless;
}

}  // namespace tern
