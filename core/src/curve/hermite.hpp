// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A segment of degree 7 from the states at its two ends. Control points 0..3 depend on the first end only, 4..7 on the
// second only. So neighbours that share a joint's state are continuous to jerk without any equations.
#ifndef TERN_CURVE_HERMITE_HPP
#define TERN_CURVE_HERMITE_HPP

#include "tern/trajectory.hpp"

namespace tern {

/// The least duration of a segment of an optimised or a stop-and-go plan, seconds. A segment of zero length gets it,
/// and no refinement goes below it. It also bounds the rounding errors of derivatives, which are differences of control
/// points over powers of the duration. 7 * 6 * 5 * 1e-14 m over (0.05 s)^3 is 2e-8 m/s^3 of jerk.
constexpr double kMinDuration = 0.05;

/// Derivatives that two segments share at a joint: position, velocity, acceleration, jerk.
constexpr int kJointOrder = 4;

/// A joint's state: d[k] is the k-th derivative with respect to time, metres and seconds.
struct JointState {
  Vec3 d[kJointOrder];
};

/// Control point k = sum_j kFirstEnd[k][j] duration^j d[j] of the first end; control point 7 - k is the same sum for
/// the second end, with odd derivatives negated.
constexpr double kFirstEnd[kJointOrder][kJointOrder] = {{1.0, 0.0, 0.0, 0.0},
                                                        {1.0, 1.0 / 7.0, 0.0, 0.0},
                                                        {1.0, 2.0 / 7.0, 1.0 / 42.0, 0.0},
                                                        {1.0, 3.0 / 7.0, 1.0 / 14.0, 1.0 / 210.0}};

/// The integral over u in [0, 1] of the squared fourth derivative, as a quadratic form in the normalised derivatives of
/// the ends: duration^j d[j] of the first end, then of the second. The integral over time is this value divided by
/// duration^7. Exact integers.
constexpr double kSnapForm[2 * kJointOrder][2 * kJointOrder] = {
    {100800, 50400, 10080, 840, -100800, 50400, -10080, 840},
    {50400, 25920, 5400, 480, -50400, 24480, -4680, 360},
    {10080, 5400, 1200, 120, -10080, 4680, -840, 60},
    {840, 480, 120, 16, -840, 360, -60, 4},
    {-100800, -50400, -10080, -840, 100800, -50400, 10080, -840},
    {50400, 24480, 4680, 360, -50400, 25920, -5400, 480},
    {-10080, -4680, -840, -60, 10080, -5400, 1200, -120},
    {840, 360, 60, 4, -840, 480, -120, 16}};

/// The state at u in [0, 1] of the segment.
JointState state_at(const Segment& segment, double u) noexcept;

/// The control points of the segment of `duration` seconds between two states. The first and the last are the states'
/// positions, bit for bit.
void control_points(const JointState& first, const JointState& second, double duration, Vec3* points) noexcept;

}  // namespace tern

#endif
