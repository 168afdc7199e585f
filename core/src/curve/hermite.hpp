// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A segment of degree 7 from the states at its two ends. Control points 0..3 depend on the first end only, 4..7 on the
// second: continuity to jerk needs no equations where neighbours share a joint's state.
#ifndef TERN_CURVE_HERMITE_HPP
#define TERN_CURVE_HERMITE_HPP

#include "tern/trajectory.hpp"

namespace tern {

/// No segment lasts less, seconds: what a segment of zero length gets, and the floor of every refinement. Derivatives
/// are differences of control points over powers of the duration, so that it also bounds their rounding errors:
/// 1e-14 m over (0.05 s)^3 is 2e-8 m/s^3 of jerk.
constexpr double kMinDuration = 0.05;

/// Derivatives that two segments share at a joint: position, velocity, acceleration, jerk.
constexpr int kJointOrder = 4;

/// A joint's state: d[k] is the k-th derivative with respect to time, metres and seconds.
struct JointState {
  Vec3 d[kJointOrder];
};

/// Control point k = sum_j kFirstEnd[k][j] duration^j d[j] of the first end; control point 7 - k the same of the
/// second end with odd derivatives negated.
constexpr double kFirstEnd[kJointOrder][kJointOrder] = {{1.0, 0.0, 0.0, 0.0},
                                                        {1.0, 1.0 / 7.0, 0.0, 0.0},
                                                        {1.0, 2.0 / 7.0, 1.0 / 42.0, 0.0},
                                                        {1.0, 3.0 / 7.0, 1.0 / 14.0, 1.0 / 210.0}};

/// The integral over u in [0, 1] of the squared fourth derivative, as a form in the ends' normalised derivatives
/// (duration^j d[j] of the first end, then of the second); over time it is this over duration^7. Exact integers.
constexpr double kSnapForm[2 * kJointOrder][2 * kJointOrder] = {
    {100800, 50400, 10080, 840, -100800, 50400, -10080, 840},
    {50400, 25920, 5400, 480, -50400, 24480, -4680, 360},
    {10080, 5400, 1200, 120, -10080, 4680, -840, 60},
    {840, 480, 120, 16, -840, 360, -60, 4},
    {-100800, -50400, -10080, -840, 100800, -50400, 10080, -840},
    {50400, 24480, 4680, 360, -50400, 25920, -5400, 480},
    {-10080, -4680, -840, -60, 10080, -5400, 1200, -120},
    {840, 360, 60, 4, -840, 480, -120, 16}};

/// Control points of the segment of that duration between two states. The outermost are the positions, bit for bit.
void control_points(const JointState& first, const JointState& second, double duration, Vec3* points) noexcept;

}  // namespace tern

#endif
