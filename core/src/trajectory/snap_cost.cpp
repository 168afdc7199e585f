// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "tern/trajectory.hpp"
#include "trajectory/bezier.hpp"

namespace tern {
namespace {

/// The integral over u in [0, 1] of the product of the cubic Bernstein polynomials i and j.
constexpr double kCubicGram[4][4] = {{1.0 / 7.0, 1.0 / 14.0, 1.0 / 35.0, 1.0 / 140.0},
                                     {1.0 / 14.0, 3.0 / 35.0, 9.0 / 140.0, 1.0 / 35.0},
                                     {1.0 / 35.0, 9.0 / 140.0, 3.0 / 35.0, 1.0 / 14.0},
                                     {1.0 / 140.0, 1.0 / 35.0, 1.0 / 14.0, 1.0 / 7.0}};

double squared_snap(Curve curve, double duration) {
  for (int k = 0; k < 4; ++k) curve = hodograph(curve, duration);
  double sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) sum += kCubicGram[i][j] * dot(curve.c[i], curve.c[j]);
  }
  return duration * sum;
}

}  // namespace

double snap_cost(const Trajectory& trajectory) noexcept {
  double cost = 0.0;
  const int count = trajectory.count < kMaxSegments ? trajectory.count : kMaxSegments;
  for (int i = 0; i < count; ++i) {
    const Segment& segment = trajectory.segments[i];
    cost += squared_snap(curve_of(segment), segment.duration);
  }
  return cost;
}

}  // namespace tern
