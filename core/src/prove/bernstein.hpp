// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The certifier's own arithmetic of Bezier curves, which it shares with no stage that makes them.
#ifndef TERN_PROVE_BERNSTEIN_HPP
#define TERN_PROVE_BERNSTEIN_HPP

#include "base/math.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// `points` become the control points of the derivative with respect to time, which are one fewer.
inline void derive(Vec3* points, int degree, double duration) {
  const double factor = degree / duration;
  for (int i = 0; i < degree; ++i) points[i] = factor * (points[i + 1] - points[i]);
}

/// de Casteljau: `points` become the part before u, `after` the part behind it.
inline void cut(Vec3* points, int degree, double u, Vec3* after) {
  for (int level = 0; level <= degree; ++level) {
    after[degree - level] = points[degree];
    for (int i = degree; i > level; --i) points[i] = (1.0 - u) * points[i - 1] + u * points[i];
  }
}

/// Derivatives that a segment is compared by: position to jerk.
constexpr int kOrders = 4;

/// Position, velocity, acceleration and jerk of a segment at one time.
struct Jet {
  Vec3 d[kOrders];
};

/// At an end of the segment.
inline Jet jet_of(const Segment& segment, bool at_end) {
  Vec3 points[kControlPoints];
  for (int i = 0; i <= kDegree; ++i) points[i] = segment.points[i];
  Jet result;
  for (int k = 0; k < kOrders; ++k) {
    result.d[k] = at_end ? points[kDegree - k] : points[0];
    derive(points, kDegree - k, segment.duration);
  }
  return result;
}

/// At u in [0, 1] of the segment.
inline Jet jet_within(const Segment& segment, double u) {
  Vec3 points[kControlPoints];
  for (int i = 0; i <= kDegree; ++i) points[i] = segment.points[i];
  Jet result;
  for (int k = 0; k < kOrders; ++k) {
    Vec3 before[kControlPoints];
    Vec3 after[kControlPoints];
    for (int i = 0; i <= kDegree - k; ++i) before[i] = points[i];
    cut(before, kDegree - k, u, after);
    result.d[k] = after[0];
    derive(points, kDegree - k, segment.duration);
  }
  return result;
}

}  // namespace tern

#endif
