// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ellipsoid/ellipsoid_metric.hpp"

#include "grid/touching.hpp"

namespace tern {
namespace {

/// The most steps of the fixed-point iteration between a grown box's normal and its nearest point. It has converged
/// once the cosine between two normals in a row is within kNormalSettled of 1.
constexpr int kNormalSteps = 3;
constexpr double kNormalSettled = 1e-6;

/// The box as bounds on the offset from the centre.
struct Bounds {
  Vector lower;
  Vector upper;
};

/// least_scale reduces its bound by this factor. The fixed-point iteration of contact_of may stop early and understate
/// a scale. The factor makes it rare that the bound exceeds that scale, so that boxes keep their order.
constexpr double kBoundShare = 0.99;

Bounds bounds_about(const Vector& center, const LocalBox& box) {
  return {vector_at(box.lower) - center, vector_at(box.upper) - center};
}

/// An offset into the box, close to the nearest one: the nearest in Euclidean distance, improved once along each axis.
Vector near_offset(const EllipsoidMetric& metric, const Bounds& bounds) {
  const Matrix& m = metric.matrix;
  Vector d;
  for (int a = 0; a < 3; ++a) d[a] = clamp(0.0, bounds.lower[a], bounds.upper[a]);
  for (int a = 0; a < 3; ++a) {
    const int b = a == 2 ? 0 : a + 1;
    const int c = a == 0 ? 2 : a - 1;
    d[a] = clamp(-(m(a, b) * d[b] + m(a, c) * d[c]) / m(a, a), bounds.lower[a], bounds.upper[a]);
  }
  return d;
}

/// The best offset so far.
struct Best {
  Vector offset;
  Vector gradient;  ///< the metric's matrix times the offset
  double value;     ///< the offset's squared length in the metric; negative while there is none
};

void offer(Best& best, const EllipsoidMetric& metric, const Vector& d) {
  const Vector gradient = multiply(metric.matrix, d);
  const double value = dot(d, gradient);
  if (best.value >= 0.0 && value >= best.value) return;
  best = {d, gradient, value};
}

/// The axis that is neither `a` nor `b`.
constexpr int third_axis(int a, int b) {
  return 3 - a - b;
}

/// Offers the best point of the edge at `at_a` on axis kA and `at_b` on axis kB: along the third axis, the free optimum
/// is clamped. Axes are constants, so that vectors stay in registers.
template <int kA, int kB>
void offer_edge(Best& best, const EllipsoidMetric& metric, const Bounds& bounds, double at_a, double at_b) {
  constexpr int kC = third_axis(kA, kB);
  Vector d;
  d[kA] = at_a;
  d[kB] = at_b;
  const double free = -(metric.matrix(kC, kA) * at_a + metric.matrix(kC, kB) * at_b) / metric.matrix(kC, kC);
  d[kC] = clamp(free, bounds.lower[kC], bounds.upper[kC]);
  offer(best, metric, d);
}

/// Offers the best point of the face at `at` on axis kA. The optimum on the whole plane is a multiple of column kA of
/// E^2.
template <int kA>
void offer_face(Best& best, const EllipsoidMetric& metric, const Bounds& bounds, double at) {
  constexpr int kB = kA == 2 ? 0 : kA + 1;
  constexpr int kC = third_axis(kA, kB);
  const double step = at / metric.shape(kA, kA);
  // No point of the whole plane of the face is nearer than this.
  if (best.value >= 0.0 && at * step >= best.value) return;
  const double free_b = metric.shape(kB, kA) * step;
  const double free_c = metric.shape(kC, kA) * step;
  const double clamped_b = clamp(free_b, bounds.lower[kB], bounds.upper[kB]);
  const double clamped_c = clamp(free_c, bounds.lower[kC], bounds.upper[kC]);
  const bool outside_b = clamped_b < free_b || clamped_b > free_b;
  const bool outside_c = clamped_c < free_c || clamped_c > free_c;
  if (!outside_b && !outside_c) {
    Vector d;
    d[kA] = at;
    d[kB] = free_b;
    d[kC] = free_c;
    return offer(best, metric, d);
  }
  if (outside_b) offer_edge<kA, kB>(best, metric, bounds, at, clamped_b);
  if (outside_c) offer_edge<kA, kC>(best, metric, bounds, at, clamped_c);
}

/// Offers the face of axis kA that faces the centre, if one does.
template <int kA>
void offer_axis(Best& best, const EllipsoidMetric& metric, const Bounds& bounds) {
  if (bounds.lower[kA] > 0.0) offer_face<kA>(best, metric, bounds, bounds.lower[kA]);
  if (bounds.upper[kA] < 0.0) offer_face<kA>(best, metric, bounds, bounds.upper[kA]);
}

Best nearest_in(const EllipsoidMetric& metric, const Bounds& bounds) {
  Best best{Vector::Zero(), Vector::Zero(), -1.0};
  offer_axis<0>(best, metric, bounds);
  offer_axis<1>(best, metric, bounds);
  offer_axis<2>(best, metric, bounds);
  return best;
}

}  // namespace

EllipsoidMetric metric_of(const EllipsoidFrame& frame) noexcept {
  EllipsoidMetric metric{frame.center, Matrix::Zero(), Matrix::Zero()};
  for (int k = 0; k < 3; ++k) {
    const double square = frame.semi_axis[k] * frame.semi_axis[k];
    const Matrix product = outer(frame.direction.col(k));
    metric.matrix += product / square;
    metric.shape += product * square;
  }
  return metric;
}

Vector nearest_offset(const EllipsoidMetric& metric, const Vector& center, const LocalBox& box) noexcept {
  return nearest_in(metric, bounds_about(center, box)).offset;
}

double least_scale(const EllipsoidMetric& metric, const LocalBox& box, double radius) noexcept {
  const Bounds bounds = bounds_about(metric.center, box);
  const Vector near = near_offset(metric, bounds);
  const Vector normal = multiply(metric.matrix, near);
  const double squared_reach = dot(normal, near);
  if (!(squared_reach > 0.0)) return -1.0;  // the box holds the centre, and only the contact tells how deep
  Vector first;
  for (int a = 0; a < 3; ++a) first[a] = normal[a] < 0.0 ? bounds.upper[a] : bounds.lower[a];
  return kBoundShare * (dot(normal, first) - radius * length(normal)) / square_root(squared_reach);
}

double reach_along(const EllipsoidMetric& metric, const Vector& normal) noexcept {
  return square_root(larger(dot(normal, multiply(metric.shape, normal)), 0.0));
}

BoxContact contact_of(const EllipsoidMetric& metric, const LocalBox& box, double radius) noexcept {
  Vector point = Vector::Zero();
  Vector normal = Vector::Zero();
  // Along a fixed normal, growing the box by the radius is the same as moving the centre towards the box by the radius.
  Vector moved = metric.center;
  for (int step = 0; step < kNormalSteps; ++step) {
    const Best nearest = nearest_in(metric, bounds_about(moved, box));
    const double norm = length(nearest.gradient);
    if (!(norm > 0.0)) break;  // the box holds the centre
    const Vector before = normal;
    normal = (1.0 / norm) * nearest.gradient;
    point = (moved + nearest.offset) - (radius * normal) - metric.center;
    if (dot(normal, before) >= 1.0 - kNormalSettled || !(radius > 0.0)) break;
    moved = metric.center + radius * normal;
  }
  const double reach = reach_along(metric, normal);
  if (!(reach > 0.0)) return {point, normal, 0.0};
  const double distance = support(to_vec3(normal), box_of(box)) - radius - dot(normal, metric.center);
  return {point, normal, distance / reach};
}

}  // namespace tern
