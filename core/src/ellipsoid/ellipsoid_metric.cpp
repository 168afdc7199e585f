// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ellipsoid/ellipsoid_metric.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

/// Steps, at most, of the fixed-point iteration between a grown box's normal and its nearest point, and the change of
/// the normal at which it has converged.
constexpr int kNormalSteps = 3;
constexpr double kNormalSettled = 1e-6;

/// The box as bounds on the offset from the centre.
struct Bounds {
  double lower[3];
  double upper[3];
};

double quadratic(const double (&m)[3][3], const double (&d)[3]) {
  const double x = (m[0][0] * d[0] + m[0][1] * d[1]) + m[0][2] * d[2];
  const double y = (m[1][0] * d[0] + m[1][1] * d[1]) + m[1][2] * d[2];
  const double z = (m[2][0] * d[0] + m[2][1] * d[1]) + m[2][2] * d[2];
  return (d[0] * x + d[1] * y) + d[2] * z;
}

/// The best offset so far.
struct Best {
  double offset[3];
  double value;
};

void offer(Best& best, const EllipsoidMetric& metric, const double (&d)[3]) {
  const double value = quadratic(metric.matrix, d);
  if (best.value >= 0.0 && value >= best.value) return;
  best = {{d[0], d[1], d[2]}, value};
}

/// Offers the best point of the edge at `at_a` on axis a and `at_b` on axis b: along axis c, the free optimum is
/// clamped.
void offer_edge(Best& best, const EllipsoidMetric& metric, const Bounds& bounds, int a, int b, int c, double at_a,
                double at_b) {
  double d[3];
  d[a] = at_a;
  d[b] = at_b;
  const double free = -(metric.matrix[c][a] * at_a + metric.matrix[c][b] * at_b) / metric.matrix[c][c];
  d[c] = clamp(free, bounds.lower[c], bounds.upper[c]);
  offer(best, metric, d);
}

/// Offers the best point of the face at `at` on axis a. The optimum on the whole plane is a multiple of column a of
/// E^2.
void offer_face(Best& best, const EllipsoidMetric& metric, const Bounds& bounds, int a, double at) {
  const int b = a == 2 ? 0 : a + 1;
  const int c = a == 0 ? 2 : a - 1;
  const double step = at / metric.shape[a][a];
  // No point of the whole plane of the face is nearer than this.
  if (best.value >= 0.0 && at * step >= best.value) return;
  const double free_b = metric.shape[b][a] * step;
  const double free_c = metric.shape[c][a] * step;
  const double clamped_b = clamp(free_b, bounds.lower[b], bounds.upper[b]);
  const double clamped_c = clamp(free_c, bounds.lower[c], bounds.upper[c]);
  const bool outside_b = clamped_b < free_b || clamped_b > free_b;
  const bool outside_c = clamped_c < free_c || clamped_c > free_c;
  if (!outside_b && !outside_c) {
    double d[3];
    d[a] = at;
    d[b] = free_b;
    d[c] = free_c;
    return offer(best, metric, d);
  }
  if (outside_b) offer_edge(best, metric, bounds, a, b, c, at, clamped_b);
  if (outside_c) offer_edge(best, metric, bounds, a, c, b, at, clamped_c);
}

}  // namespace

EllipsoidMetric metric_of(const EllipsoidFrame& frame) noexcept {
  EllipsoidMetric metric;
  metric.center = frame.center;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      metric.matrix[i][j] = 0.0;
      metric.shape[i][j] = 0.0;
    }
  }
  for (int k = 0; k < 3; ++k) {
    const double square = frame.semi_axis[k] * frame.semi_axis[k];
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const double product = axis(frame.direction[k], i) * axis(frame.direction[k], j);
        metric.matrix[i][j] += product / square;
        metric.shape[i][j] += product * square;
      }
    }
  }
  return metric;
}

Ellipsoid ellipsoid_of(const EllipsoidFrame& frame) noexcept {
  Ellipsoid ellipsoid;
  ellipsoid.center = frame.center;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      double sum = 0.0;
      for (int k = 0; k < 3; ++k) {
        sum += axis(frame.direction[k], i) * axis(frame.direction[k], j) * frame.semi_axis[k];
      }
      ellipsoid.axes[i][j] = sum;
    }
  }
  return ellipsoid;
}

Vec3 nearest_offset(const EllipsoidMetric& metric, const Vec3& center, const LocalBox& box) noexcept {
  Bounds bounds;
  Best best{{0.0, 0.0, 0.0}, -1.0};
  for (int a = 0; a < 3; ++a) {
    bounds.lower[a] = box.lower[a] - axis(center, a);
    bounds.upper[a] = box.upper[a] - axis(center, a);
  }
  for (int a = 0; a < 3; ++a) {
    if (bounds.lower[a] > 0.0) offer_face(best, metric, bounds, a, bounds.lower[a]);
    if (bounds.upper[a] < 0.0) offer_face(best, metric, bounds, a, bounds.upper[a]);
  }
  return {best.offset[0], best.offset[1], best.offset[2]};
}

double reach_along(const EllipsoidMetric& metric, const Vec3& normal) noexcept {
  return square_root(larger(dot(normal, multiply(metric.shape, normal)), 0.0));
}

Contact contact_of(const EllipsoidMetric& metric, const LocalBox& box, double radius) noexcept {
  Contact contact{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0.0};
  // Along a fixed normal, growing the box by the radius is the same as moving the centre towards the box by the radius.
  Vec3 moved = metric.center;
  for (int step = 0; step < kNormalSteps; ++step) {
    const Vec3 offset = nearest_offset(metric, moved, box);
    const Vec3 gradient = multiply(metric.matrix, offset);
    const double norm = length(gradient);
    if (!(norm > 0.0)) break;  // the box holds the centre
    const Vec3 normal = (1.0 / norm) * gradient;
    const bool settled = dot(normal, contact.normal) >= 1.0 - kNormalSettled;
    contact.normal = normal;
    contact.point = (moved + offset) - (radius * normal) - metric.center;
    if (settled || !(radius > 0.0)) break;
    moved = metric.center + radius * normal;
  }
  const double reach = reach_along(metric, contact.normal);
  if (!(reach > 0.0)) return contact;
  contact.scale = (support(contact.normal, box) - radius - dot(contact.normal, metric.center)) / reach;
  return contact;
}

}  // namespace tern
