// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// States at rest, motion backwards in time, and the straight segment between two points at rest.
#ifndef TERN_CURVE_REST_HPP
#define TERN_CURVE_REST_HPP

#include "base/bounds.hpp"
#include "tern/request.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// Peak speed and acceleration of the profile 35 u^4 - 84 u^5 + 70 u^6 - 20 u^7 (four equal control points at each
/// end): at u = 1/2 and at u = (5 - sqrt 5) / 10.
constexpr double kRestPeakSpeed = 35.0 / 16.0;
constexpr double kRestPeakAcceleration = 7.51318840439929325;  // 84 sqrt(5) / 25
/// Peak jerk of this profile, at u = 1/2.
constexpr double kRestPeakJerk = 52.5;

/// True if velocity, acceleration and jerk are zero.
bool at_rest(const State& state) noexcept;

/// The state, or the segment, flown backwards in time.
State backwards(const State& state) noexcept;
Segment reversed(const Segment& segment) noexcept;

/// The straight segment from rest to rest, with the profile of kRestPeakSpeed and as fast as the limits allow. It lasts
/// at least kMinDuration. If both ends are the same point, it stays there for kMinDuration.
Segment straight_segment(const Vec3& from, const Vec3& to, int polyhedron, const MotionLimits& limits) noexcept;

}  // namespace tern

#endif
