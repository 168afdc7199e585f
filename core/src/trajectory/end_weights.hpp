// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The weights of a programme's points. A point is a weighted sum of control points, and so a weighted sum of the
// normalised derivatives at both ends of its segment. The weights are constants: they depend on no map and no plan.
#ifndef TERN_TRAJECTORY_END_WEIGHTS_HPP
#define TERN_TRAJECTORY_END_WEIGHTS_HPP

#include "curve/hermite.hpp"
#include "trajectory/hodograph_points.hpp"

namespace tern {

/// Weights of the derivatives of both ends: first those of the first end, then those of the second.
struct EndWeights {
  double of[2 * kJointOrder];
  bool touches[2];  ///< false: the point does not depend on that end
};

/// The weight of derivative j of an end in the weighted sum of that end's four control points.
constexpr double end_weight(const double* weights, int end, int j) {
  double sum = 0.0;
  for (int k = j; k < kJointOrder; ++k) {
    sum += weights[end == 0 ? k : kDegree - k] * kFirstEnd[k][j];
  }
  return end == 1 && (j % 2) == 1 ? -sum : sum;
}

constexpr bool touches_end(const double* weights, int end) {
  for (int k = end * kJointOrder; k < (end + 1) * kJointOrder; ++k) {
    if (weights[k] < 0.0 || weights[k] > 0.0) return true;
  }
  return false;
}

constexpr EndWeights end_weights(const double* weights) {
  EndWeights result{};
  for (int end = 0; end < 2; ++end) {
    result.touches[end] = touches_end(weights, end);
    for (int j = 0; j < kJointOrder; ++j) result.of[end * kJointOrder + j] = end_weight(weights, end, j);
  }
  return result;
}

/// The weights of all points, by the order of the derivative: the control points (order 0), and those of
/// HodographPoints.
struct EndWeightTable {
  EndWeights position[kControlPoints];
  EndWeights velocity[kVelocityPoints];
  EndWeights acceleration[kAccelerationPoints];
  EndWeights jerk[kJerkPoints];
};

constexpr EndWeightTable make_end_weight_table() {
  EndWeightTable table{};
  for (int k = 0; k < kControlPoints; ++k) {
    double weights[kControlPoints] = {};
    weights[k] = 1.0;
    table.position[k] = end_weights(weights);
  }
  for (int r = 0; r < kVelocityPoints; ++r) table.velocity[r] = end_weights(kHodographPoints.velocity[r]);
  for (int r = 0; r < kAccelerationPoints; ++r) table.acceleration[r] = end_weights(kHodographPoints.acceleration[r]);
  for (int r = 0; r < kJerkPoints; ++r) table.jerk[r] = end_weights(kHodographPoints.jerk[r]);
  return table;
}

constexpr EndWeightTable kEndWeightTable = make_end_weight_table();

/// The weights of a segment's points of one order, 0 to 3.
struct EndWeightList {
  const EndWeights* list;
  int count;
};

constexpr EndWeightList end_weights_of(int order) {
  if (order == 0) return {kEndWeightTable.position, kControlPoints};
  if (order == 1) return {kEndWeightTable.velocity, kVelocityPoints};
  if (order == 2) return {kEndWeightTable.acceleration, kAccelerationPoints};
  return {kEndWeightTable.jerk, kJerkPoints};
}

}  // namespace tern

#endif
