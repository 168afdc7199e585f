// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The brake for a threat: straight ahead, and as sharp as the limits allow.
#ifndef TERN_FLIGHT_SHARP_STOP_HPP
#define TERN_FLIGHT_SHARP_STOP_HPP

#include "base/bounds.hpp"
#include "curve/hermite.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// Appends a brake that takes the jerk to zero, ramps to a steady deceleration, holds it, and ramps back to zero. Its
/// ramps are the shortest ones that the limits on jerk allow, kMinDuration at least. Of the times in which the jerk
/// goes to zero (kSettleTime, halved up to kSettleHalvings times), it takes the one with the shortest way to rest. The
/// brake never takes the acceleration to zero before the ramp: at its speed limit, a vehicle whose speed still rises
/// must not wait.
///
/// False if there is no room, or if no such brake keeps the limits. Positions are relative to `out.origin`.
bool append_sharp_stop(const JointState& from, const MotionLimits& limits, Trajectory& out) noexcept;

}  // namespace tern

#endif
