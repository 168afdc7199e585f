// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "curve/hermite.hpp"

#include "base/math.hpp"
#include "curve/bezier.hpp"

namespace tern {
namespace {

/// Control point k, counted from the end that it is next to. `step` is the duration for the first end, and minus the
/// duration for the second end.
Vec3 point_beside(const JointState& end, double step, int k) {
  Vec3 point = end.d[0];
  double power = step;
  for (int j = 1; j <= k; ++j) {
    point = point + (kFirstEnd[k][j] * power) * end.d[j];
    power *= step;
  }
  return point;
}

}  // namespace

JointState state_at(const Segment& segment, double u) noexcept {
  JointState state;
  Curve curve = curve_of(segment);
  for (Vec3& derivative : state.d) {
    derivative = value(curve, u);
    curve = hodograph(curve, segment.duration);
  }
  return state;
}

void control_points(const JointState& first, const JointState& second, double duration, Vec3* points) noexcept {
  for (int k = 0; k < kJointOrder; ++k) {
    points[k] = point_beside(first, duration, k);
    points[kDegree - k] = point_beside(second, -duration, k);
  }
}

}  // namespace tern
