// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "attack/curve.hpp"

namespace tern_attack {

Curve curve_of(const tern::Vec3* points, const Point& shift) {
  Curve curve{tern::kDegree, {}, 0, 1};
  for (int i = 0; i <= tern::kDegree; ++i) curve.p[i] = point(points[i]) + shift;
  return curve;
}

Curve line(const Point& from, const Point& to) {
  Curve curve{1, {}, 0, 1};
  curve.p[0] = from;
  curve.p[1] = to;
  return curve;
}

Curve derivative(const Curve& curve, Real duration) {
  Curve result{curve.degree - 1, {}, curve.from, curve.to};
  const Real scale = static_cast<Real>(curve.degree) / duration;
  for (int i = 0; i < curve.degree; ++i) result.p[i] = scale * (curve.p[i + 1] - curve.p[i]);
  return result;
}

void split(const Curve& curve, Curve& left, Curve& right) {
  left = curve;
  right = curve;
  for (int level = 1; level <= curve.degree; ++level) {
    for (int i = curve.degree; i >= level; --i) left.p[i] = 0.5L * (left.p[i - 1] + left.p[i]);
    right.p[curve.degree - level] = left.p[curve.degree];
  }
  const Real middle = 0.5L * (curve.from + curve.to);
  left.to = middle;
  right.from = middle;
}

Curve between(const Curve& curve, Real from, Real to) {
  Curve result = curve;
  for (int level = 1; level <= curve.degree; ++level) {
    for (int i = curve.degree; i >= level; --i) result.p[i] = (1 - to) * result.p[i - 1] + to * result.p[i];
  }
  const Real u = to > 0 ? from / to : 0;
  for (int level = 1; level <= curve.degree; ++level) {
    for (int i = 0; i <= curve.degree - level; ++i) result.p[i] = (1 - u) * result.p[i] + u * result.p[i + 1];
  }
  return result;
}

Point value(const Curve& curve, Real u) {
  Curve work = curve;
  for (int level = 1; level <= curve.degree; ++level) {
    for (int i = 0; i <= curve.degree - level; ++i) work.p[i] = (1 - u) * work.p[i] + u * work.p[i + 1];
  }
  return work.p[0];
}

Real magnitude(const Curve& curve) {
  Real most = 0;
  for (int i = 0; i <= curve.degree; ++i) most = std::max(most, largest(curve.p[i]));
  return most;
}

Real longest(const Curve& curve) {
  Real most = 0;
  for (int i = 0; i <= curve.degree; ++i) most = std::max(most, length(curve.p[i]));
  return most;
}

}  // namespace tern_attack
