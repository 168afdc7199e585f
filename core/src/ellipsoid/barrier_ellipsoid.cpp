// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ellipsoid/barrier_ellipsoid.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

constexpr int kBarrierSteps = 20;
/// Newton decrement at which the point is close enough to the centre for its ellipsoid to be used.
constexpr double kCentred = 1e-2;

/// Returns the gradient of the barrier -sum log(slack), and stores its Hessian as the metric's matrix.
Vec3 gradient_and_hessian(const Polyhedron& polyhedron, double least_slack, EllipsoidMetric& metric) {
  Vec3 gradient{0.0, 0.0, 0.0};
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;
  for (int p = 0; p < polyhedron.count; ++p) {
    const Halfspace& plane = polyhedron.planes[p];
    const double slack = larger(plane.offset - dot(plane.normal, metric.center), least_slack);
    const Vec3 row = (1.0 / slack) * plane.normal;
    gradient = gradient + row;
    xx += row.x * row.x;
    xy += row.x * row.y;
    xz += row.x * row.z;
    yy += row.y * row.y;
    yz += row.y * row.z;
    zz += row.z * row.z;
  }
  const double matrix[3][3] = {{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) metric.matrix[i][j] = matrix[i][j];
  }
  return gradient;
}

/// Computes E^2 from E^-2 by cofactors and returns det(E^2). Because of the box's faces, the matrix is never near
/// singular.
double invert(EllipsoidMetric& metric) {
  const double(&m)[3][3] = metric.matrix;
  const double xx = m[1][1] * m[2][2] - m[1][2] * m[1][2];
  const double xy = m[1][2] * m[0][2] - m[0][1] * m[2][2];
  const double xz = m[0][1] * m[1][2] - m[1][1] * m[0][2];
  const double yy = m[0][0] * m[2][2] - m[0][2] * m[0][2];
  const double yz = m[0][1] * m[0][2] - m[0][0] * m[1][2];
  const double zz = m[0][0] * m[1][1] - m[0][1] * m[0][1];
  const double scale = 1.0 / ((m[0][0] * xx + m[0][1] * xy) + m[0][2] * xz);
  const double inverse[3][3] = {{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) metric.shape[i][j] = scale * inverse[i][j];
  }
  return scale;
}

}  // namespace

BarrierEllipsoid barrier_ellipsoid(const Polyhedron& polyhedron, const Vec3& inside, double least_slack) noexcept {
  BarrierEllipsoid result;
  EllipsoidMetric& metric = result.metric;
  metric.center = inside;
  Vec3 gradient = gradient_and_hessian(polyhedron, least_slack, metric);
  double determinant = invert(metric);
  for (int step = 0; step < kBarrierSteps; ++step) {
    const Vec3 newton = multiply(metric.shape, gradient);
    const double decrement = square_root(larger(dot(newton, gradient), 0.0));
    if (decrement < kCentred) break;
    metric.center = metric.center - (1.0 / (1.0 + decrement)) * newton;
    gradient = gradient_and_hessian(polyhedron, least_slack, metric);
    determinant = invert(metric);
  }
  const double planes = static_cast<double>(polyhedron.count);
  result.size = determinant * (planes * planes * planes);
  return result;
}

}  // namespace tern
