// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "prove/turning.hpp"

#include "base/math.hpp"
#include "prove/bernstein.hpp"
#include "tern/flatness.hpp"

namespace tern {
namespace {

constexpr int kF = kDegree - 2;  ///< degree of the thrust
constexpr int kJ = kDegree - 3;  ///< degree of the jerk
constexpr int kTop = 2 * kF;     ///< degree of the comparison

/// Thrust and jerk of a part of a segment.
struct Motion {
  Vec3 thrust[kControlPoints];
  Vec3 jerk[kControlPoints];
};

void load(const Segment& segment, int order, double begin, double end, Vec3* points) {
  Vec3 rest[kControlPoints];
  for (int i = 0; i <= kDegree; ++i) points[i] = segment.points[i];
  for (int k = 0; k < order; ++k) derive(points, kDegree - k, segment.duration);
  const int degree = kDegree - order;
  cut(points, degree, end, rest);
  if (!(begin > 0.0)) return;
  cut(points, degree, begin / end, rest);
  for (int i = 0; i <= degree; ++i) points[i] = rest[i];
}

Motion motion_of(const Segment& segment, double begin, double end) {
  Motion motion;
  load(segment, 2, begin, end, motion.thrust);
  load(segment, 3, begin, end, motion.jerk);
  for (int i = 0; i <= kF; ++i) motion.thrust[i].z += kGravity;
  return motion;
}

/// The binomial coefficient.
constexpr double choose(int n, int k) {
  double product = 1.0;
  for (int i = 1; i <= k; ++i) product = product * (n - k + i) / i;
  return product;
}

/// Weight of the product of coefficients i and k of degrees m and n in coefficient i + k of degree m + n.
struct Weights {
  double of[kF + 1][kF + 1];
};
constexpr Weights make_weights(int m, int n) {
  Weights weights{};
  for (int i = 0; i <= m; ++i) {
    for (int k = 0; k <= n; ++k) weights.of[i][k] = choose(m, i) * choose(n, k) / choose(m + n, i + k);
  }
  return weights;
}
constexpr Weights kSquares = make_weights(kF, kF);
constexpr Weights kCrosses = make_weights(kJ, kF);

}  // namespace

bool turning_allowed(const Segment& segment, double begin, double end, const TurningRule& rule) noexcept {
  const Motion motion = motion_of(segment, begin, end);
  Vec3 turns[kTop] = {};
  double squares[kTop + 1] = {};
  for (int k = 0; k <= kF; ++k) {
    for (int i = 0; i <= kF; ++i) squares[i + k] += kSquares.of[i][k] * dot(motion.thrust[i], motion.thrust[k]);
    for (int i = 0; i <= kJ; ++i) {
      turns[i + k] = turns[i + k] + kCrosses.of[i][k] * cross(motion.jerk[i], motion.thrust[k]);
    }
  }
  for (int i = 0; i <= kTop; ++i) {
    const double part = static_cast<double>(i) / kTop;
    const Vec3 raised = (i > 0 ? part * turns[i - 1] : kZero) + (i < kTop ? (1.0 - part) * turns[i] : kZero);
    const double rounding = rule.rounding * square_root(larger(0.0, squares[i]));
    if (!(length(raised) <= rule.most * squares[i] + rounding)) return false;
  }
  return true;
}

double turning_at(const Segment& segment, double u) noexcept {
  const bool late = u > 0.5;
  const Motion motion = motion_of(segment, late ? 0.0 : u, late ? u : 1.0);
  const Vec3& thrust = motion.thrust[late ? kF : 0];
  const double square = dot(thrust, thrust);
  return square > 0.0 ? length(cross(motion.jerk[late ? kJ : 0], thrust)) / square : 0.0;
}

}  // namespace tern
