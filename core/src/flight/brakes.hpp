// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The brakes of an evasion: straight ahead, or along the path of a trajectory. Positions are relative to `out.origin`.
#ifndef TERN_FLIGHT_BRAKES_HPP
#define TERN_FLIGHT_BRAKES_HPP

#include "base/bounds.hpp"
#include "curve/hermite.hpp"
#include "flight/branch.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// How many slow-downs are tried, the sharpest first.
constexpr int kSlowDowns = 6;
/// Brakes of an evasion by number: the sharp stop, the stops of append_stop(), the sharpest first, and the slow-downs.
constexpr int kStraight = 1 + kStops;
constexpr int kEvasions = kStraight + kSlowDowns;

/// Appends a brake that takes the jerk to zero, ramps to a steady deceleration, holds it, and ramps back to zero. Its
/// ramps are the shortest ones that the limits on jerk allow, kMinDuration at least. Of the times in which the jerk
/// goes to zero (kSettleTime, halved up to kSettleHalvings times), it takes the one with the shortest way to rest. The
/// brake never takes the acceleration to zero before the ramp: at its speed limit, a vehicle whose speed still rises
/// must not wait.
///
/// False if there is no room, or if no such brake keeps the limits.
bool append_sharp_stop(const JointState& from, const MotionLimits& limits, Trajectory& out) noexcept;

/// How long slow-down `way` of 0 .. kSlowDowns - 1 takes from this velocity, seconds. On a straight path flown at a
/// constant speed, the sharpest one brakes at the limit of acceleration or of jerk.
double slow_down_time(const Vec3& velocity, const MotionLimits& limits, int way) noexcept;

/// Appends the plan's path from `from` on, flown ever slower until it rests after `time` > 0: if the path is clear, so
/// is the brake. It begins in the plan's state, from position to jerk, and ends half of that time further along the
/// plan, or at its end. Every joint lies on the path; in between, the error is below kProofTolerance for common limits.
/// The caller has to check the limits. False if there is no room (kMaxSegments).
bool append_slow_down(const Trajectory& plan, double from, double time, Trajectory& out) noexcept;

}  // namespace tern

#endif
