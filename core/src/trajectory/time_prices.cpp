// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "curve/bezier.hpp"
#include "trajectory/hodograph_points.hpp"
#include "trajectory/programme.hpp"
#include "trajectory/programme_points.hpp"

namespace tern {
namespace {

/// -T d/dT of the integral of squared snap. The form is homogeneous: of degree 2 in the points and -7 in T.
double snap_price(const Vec3* points, const Vec3* drift, double duration) {
  Segment segment;
  segment.polyhedron = 0;
  segment.duration = duration;
  for (int k = 0; k < kControlPoints; ++k) segment.points[k] = points[k];
  const Curve snap = snap_of(segment);
  for (int k = 0; k < kControlPoints; ++k) segment.points[k] = drift[k];
  const Curve change = snap_of(segment);
  return 7.0 * integral_of_product(snap, snap, duration) - 2.0 * integral_of_product(snap, change, duration);
}

/// T d/dT of a programme's point, which is sum_k w_k c_k / (T^order unit).
Vec3 point_drift(const PointOrigin& origin, const Vec3* points, const Vec3* drift, double duration, double unit) {
  if (origin.order == 0) return drift[origin.index];
  const double* const weights = points_of(origin.order).weights[origin.index];
  Vec3 sum = kZero;
  for (int k = 0; k < kControlPoints; ++k)
    sum = sum + weights[k] * (drift[k] - static_cast<double>(origin.order) * points[k]);
  return (1.0 / (power_of(duration, origin.order) * unit)) * sum;
}

}  // namespace

void time_prices(const Chain& chain, const QpProblem& problem, const QpSolution& solution, const ProgrammeScale& scale,
                 const Vec3 (*points)[kControlPoints], double* prices) noexcept {
  Vec3 drift[kControlPoints];
  for (int i = 0; i < chain.count; ++i) {
    drift_of(points[i], drift);
    prices[i] = snap_price(points[i], drift, chain.duration[i]);
  }
  for (int r = 0; r < solution.active_count; ++r) {
    const QpConstraint& active = solution.active[r];
    const PointOrigin& origin = scale.origin[active.point];
    if (origin.order < 0) continue;
    const int i = origin.segment;
    drift_of(points[i], drift);
    const Vec3 change = point_drift(origin, points[i], drift, chain.duration[i], scale.unit[origin.order]);
    prices[i] -= scale.snap_per_cost * solution.multiplier[r] * dot(problem.planes[active.plane].normal, change);
  }
}

}  // namespace tern
