// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "durations/vehicle_rows.hpp"

#include <cmath>

#include "base/math.hpp"

namespace tern_bench {
namespace {

using tern::axis;
using tern::kDegree;
using tern::kJointOrder;
using tern::Vec3;

/// Instants a segment, its ends included.
constexpr int kInstants = 13;
constexpr int kTheta = 6 * kJointOrder;

using EndWeights = std::array<double, 2 * kJointOrder>;

/// Weights of the ends in derivative `order` at u, without powers of the time.
EndWeights weights_at(int order, double u) {
  EndWeights result{};
  for (int e = 0; e < 2 * kJointOrder; ++e) {
    double c[tern::kControlPoints] = {};
    const int j = e % kJointOrder;
    for (int k = j; k < kJointOrder; ++k) {
      const double w = tern::kFirstEnd[k][j];
      (e < kJointOrder ? c[k] : c[kDegree - k]) = e >= kJointOrder && j % 2 == 1 ? -w : w;
    }
    int degree = kDegree;
    for (int k = 0; k < order; ++k, --degree) {
      for (int i = 0; i < degree; ++i) c[i] = degree * (c[i + 1] - c[i]);
    }
    for (; degree > 0; --degree) {
      for (int i = 0; i < degree; ++i) c[i] = (1.0 - u) * c[i] + u * c[i + 1];
    }
    result[e] = c[0];
  }
  return result;
}

/// Those of acceleration and jerk at every instant.
struct WeightTable {
  EndWeights of[4][kInstants];

  WeightTable() {
    for (int order = 2; order < 4; ++order) {
      for (int k = 0; k < kInstants; ++k) of[order][k] = weights_at(order, k / (kInstants - 1.0));
    }
  }
};
const WeightTable kWeights;

/// Derivative `order` at the row's instant; `by_theta` its derivative by theta.
Vec3 derivative_at(int order, const VehicleRow& row, double tau, const Local& x, Vec3& by_theta,
                   std::array<double, 2 * kJointOrder>& factors) {
  const EndWeights& weights = kWeights.of[order][row.instant];
  const double growth = std::exp(x[kTheta]);
  double power = 1.0;
  for (int k = 0; k < order; ++k) power /= growth * tau;
  std::array<double, kJointOrder> powers;
  for (int j = 0; j < kJointOrder; ++j, power *= growth) powers[j] = power;
  Vec3 sum{0.0, 0.0, 0.0};
  by_theta = sum;
  for (int e = 0; e < 2 * kJointOrder; ++e) {
    const int m = e % kJointOrder - order;
    factors[e] = weights[e] * powers[e % kJointOrder];
    const Vec3 term{factors[e] * x[3 * e], factors[e] * x[3 * e + 1], factors[e] * x[3 * e + 2]};
    sum = sum + term;
    by_theta = by_theta + static_cast<double>(m) * term;
  }
  return sum;
}

/// The value, and its derivatives by thrust and jerk.
double value_of(VehicleRowKind kind, const tern::MotionLimits& limits, const Vec3& f, const Vec3& j, Vec3& by_f,
                Vec3& by_j) {
  const tern::Bounds& a = limits.acceleration;
  by_j = tern::kZero;
  if (kind == VehicleRowKind::kMost) {
    by_f = (2.0 / (a.thrust * a.thrust)) * f;
    return dot(f, f) / (a.thrust * a.thrust) - 1.0;
  }
  if (kind == VehicleRowKind::kLeast) {
    by_f = {0.0, 0.0, -1.0 / a.hover};
    return (a.hover + a.lower.z - f.z) / a.hover;
  }
  if (kind == VehicleRowKind::kTilt) {
    const double unit = 1.0 / (a.hover * a.hover);
    const double square = a.slope * a.slope;
    by_f = unit * Vec3{2.0 * f.x, 2.0 * f.y, -2.0 * square * f.z};
    return unit * (f.x * f.x + f.y * f.y - square * f.z * f.z);
  }
  const double thrust = dot(f, f);
  const double along = dot(j, f);
  const double turn = dot(j, j) * thrust - along * along;
  const double unit = 1.0 / (limits.rate * limits.rate * thrust * thrust);
  by_j = (2.0 * unit) * (thrust * j - along * f);
  by_f = (2.0 * unit) * (dot(j, j) * f - along * j - (2.0 * turn / thrust) * f);
  return unit * turn - 1.0;
}

}  // namespace

std::vector<VehicleRow> vehicle_rows(const tern::MotionLimits& limits, int segments) {
  std::vector<VehicleRow> rows;
  const tern::Bounds& a = limits.acceleration;
  const bool any = a.thrust > 0.0 || a.slope > 0.0 || limits.rate > 0.0;
  for (int i = 0; any && i < segments; ++i) {
    for (int k = i == 0 ? 1 : 0; k < kInstants - (i + 1 == segments ? 1 : 0); ++k) {
      if (a.thrust > 0.0) rows.push_back({VehicleRowKind::kMost, i, k});
      rows.push_back({VehicleRowKind::kLeast, i, k});
      if (a.slope > 0.0) rows.push_back({VehicleRowKind::kTilt, i, k});
      if (limits.rate > 0.0) rows.push_back({VehicleRowKind::kRate, i, k});
    }
  }
  return rows;
}

double vehicle_value(const VehicleRow& row, const tern::MotionLimits& limits, double tau, const Local& x,
                     Local* gradient) {
  std::array<double, 2 * kJointOrder> a_factors{};
  std::array<double, 2 * kJointOrder> j_factors{};
  Vec3 a_theta, j_theta, by_f, by_j;
  const Vec3 f = derivative_at(2, row, tau, x, a_theta, a_factors) + Vec3{0.0, 0.0, limits.acceleration.hover};
  const Vec3 j = derivative_at(3, row, tau, x, j_theta, j_factors);
  const double value = value_of(row.kind, limits, f, j, by_f, by_j);
  if (gradient == nullptr) return value;
  for (int e = 0; e < 2 * kJointOrder; ++e) {
    for (int k = 0; k < 3; ++k) (*gradient)[3 * e + k] = a_factors[e] * axis(by_f, k) + j_factors[e] * axis(by_j, k);
  }
  (*gradient)[kTheta] = dot(by_f, a_theta) + dot(by_j, j_theta);
  return value;
}

}  // namespace tern_bench
