// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Curves for the check, which shares no code with the stages that made them.
#ifndef TERN_CHECK_HODOGRAPH_HPP
#define TERN_CHECK_HODOGRAPH_HPP

#include "base/math.hpp"
#include "tern/trajectory.hpp"

namespace tern {
namespace checked {

/// Bernstein coefficients of a curve; those beyond its degree are not set.
struct Curve {
  Vec3 c[kControlPoints];
  int degree;
};

inline Curve position_of(const Segment& segment) {
  Curve curve;
  curve.degree = kDegree;
  for (int i = 0; i <= kDegree; ++i) curve.c[i] = segment.points[i];
  return curve;
}

/// The hodograph: derivative with respect to time of a curve that lasts `duration` seconds.
inline Curve derivative(const Curve& curve, double duration) {
  Curve result;
  result.degree = curve.degree - 1;
  for (int i = 0; i < curve.degree; ++i) result.c[i] = (curve.degree / duration) * (curve.c[i + 1] - curve.c[i]);
  return result;
}

/// Position and derivatives to jerk at a segment's beginning or end.
struct Jet {
  Vec3 d[4];
};

inline Jet jet(const Segment& segment, bool at_end) {
  Jet result;
  Curve curve = position_of(segment);
  for (int k = 0; k < 4; ++k) {
    result.d[k] = at_end ? curve.c[curve.degree] : curve.c[0];
    if (k < 3) curve = derivative(curve, segment.duration);
  }
  return result;
}

}  // namespace checked
}  // namespace tern

#endif
