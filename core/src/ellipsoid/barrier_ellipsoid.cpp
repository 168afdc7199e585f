// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ellipsoid/barrier_ellipsoid.hpp"

namespace tern {
namespace {

constexpr int kBarrierSteps = 20;
/// Newton decrement at which the point is close enough to the centre for its ellipsoid to be used.
constexpr double kCentred = 1e-2;

/// Returns the gradient of the barrier -sum log(slack), and stores its Hessian as the metric's matrix.
void differentiate(const Polyhedron& polyhedron, double least_slack, EllipsoidMetric& metric, Vector& gradient) {
  // Sums up in local variables: a sum behind a reference would be stored for every half-space.
  const Vector center = metric.center;
  Vector rows = Vector::Zero();
  Matrix products = Matrix::Zero();
  for (int p = 0; p < polyhedron.count; ++p) {
    const Vector normal = to_vector(polyhedron.planes[p].normal);
    const double slack = larger(polyhedron.planes[p].offset - dot(normal, center), least_slack);
    const Vector row = (1.0 / slack) * normal;
    rows += row;
    products += outer(row);
  }
  gradient = rows;
  metric.matrix = products;
}

/// Computes E^2 from E^-2 by cofactors and returns det(E^2). Because of the box's faces, the matrix is never near
/// singular.
double invert(EllipsoidMetric& metric) {
  const Matrix& m = metric.matrix;
  Matrix cofactors;
  cofactors.col(0) = cross(m.col(1), m.col(2));
  cofactors.col(1) = cross(m.col(2), m.col(0));
  cofactors.col(2) = cross(m.col(0), m.col(1));
  const double scale = 1.0 / dot(m.col(0), cofactors.col(0));
  metric.shape = scale * cofactors;
  return scale;
}

}  // namespace

BarrierEllipsoid barrier_ellipsoid(const Polyhedron& polyhedron, const Vector& inside, double least_slack,
                                   Work& work) noexcept {
  BarrierEllipsoid result;
  EllipsoidMetric& metric = result.metric;
  metric.center = inside;
  Vector gradient;
  differentiate(polyhedron, least_slack, metric, gradient);
  double determinant = invert(metric);
  int steps = 1;
  for (; steps <= kBarrierSteps; ++steps) {
    const Vector newton = multiply(metric.shape, gradient);
    const double decrement = square_root(larger(dot(newton, gradient), 0.0));
    if (decrement < kCentred) break;
    metric.center -= (1.0 / (1.0 + decrement)) * newton;
    differentiate(polyhedron, least_slack, metric, gradient);
    determinant = invert(metric);
  }
  const double planes = static_cast<double>(polyhedron.count);
  result.size = determinant * (planes * planes * planes);
  work.spend((ops::kPiece + 2 * ops::kDot * polyhedron.count) * steps);
  return result;
}

}  // namespace tern
