// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The rate at which a flight turns the thrust: |jerk x thrust| / |thrust|^2, which is roll and pitch rate together.
#ifndef TERN_CURVE_BODY_RATE_HPP
#define TERN_CURVE_BODY_RATE_HPP

#include "curve/bezier.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// A tight upper bound of the body rate over the segment, rad/s, like peak_bound() in curve/bezier.hpp: at least the
/// supremum, and at most the larger of `floor` and (1 + tolerance) * supremum. Infinite where the thrust may be zero.
double peak_rate(const Segment& segment, double floor, double tolerance) noexcept;
constexpr int kRateDepth = 14;
constexpr int kRatePieces = 256;

/// The body rate at one acceleration and jerk, rad/s; infinite without thrust.
double body_rate(const Vec3& acceleration, const Vec3& jerk) noexcept;

}  // namespace tern

#endif
