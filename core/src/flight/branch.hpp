// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pieces that committed plans are made of: the first part of a trajectory, a segment that takes the jerk to zero, and
// brakes, in closed form or along the path. Every function appends to a trajectory; positions are relative to its
// origin.
#ifndef TERN_FLIGHT_BRANCH_HPP
#define TERN_FLIGHT_BRANCH_HPP

#include "base/bounds.hpp"
#include "base/work.hpp"
#include "curve/brake.hpp"
#include "curve/hermite.hpp"
#include "curve/stopping.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// The longest time that the jerk takes to go to zero, seconds, and how often it may be halved to keep the limits.
constexpr double kSettleTime = 0.05;
constexpr int kSettleHalvings = 5;

/// How long the jerk takes to go to zero from this state, seconds.
double settle_time(const JointState& from, const MotionLimits& limits) noexcept;
/// The state after `time` seconds in which the jerk falls to zero at a constant rate.
JointState settled(const JointState& from, double time) noexcept;

/// Position to jerk of a trajectory at time `t`, the position relative to `origin`.
JointState joint_at(const Trajectory& plan, double t, const Vec3& origin) noexcept;

/// `out` becomes the part of the plan after `t`, up to the last segment that begins within `ahead` seconds. If nothing
/// follows `t`, `out` rests at the plan's end. 0 <= t.
void take_remainder(const Trajectory& plan, double t, double ahead, Trajectory& out) noexcept;

/// Appends the segment between two states. False if there is no room (kMaxSegments).
bool append_between(const JointState& from, const JointState& to, double time, Trajectory& out) noexcept;

/// In a segment shorter than this, seconds, the rounding of control points makes tens of m/s^3 of jerk.
constexpr double kSliver = 1e-3;
/// The joint before `t` if that is nearer than kSliver, otherwise `t`. A plan that is cut there does not end in a
/// sliver.
double off_joints(const Trajectory& plan, double t) noexcept;

/// `out` becomes the part of the plan before `t` > 0. All its segments but the last have the bits of the plan's.
void take_first_part(const Trajectory& plan, double t, Trajectory& out) noexcept;

/// Appends a segment that takes the jerk to zero, then a brake straight ahead. The stop is sharper if the jerk is zero
/// first. `way` is 0 .. kStops - 1, the sharpest first. False if there is no room, or if the limits do not hold.
/// `scratch` is the caller's because it is large for the stack.
constexpr int kStops = kBrakeShapes;
bool append_stop(const JointState& from, const MotionLimits& limits, int way, Stopping& scratch,
                 Trajectory& out) noexcept;

/// How many slow-downs are tried, the sharpest first.
constexpr int kSlowDowns = 6;
/// Brakes of an evasion by number: the sharp stop, the stops of append_stop(), the sharpest first, and the slow-downs.
constexpr int kStraight = 1 + kStops;
constexpr int kEvasions = kStraight + kSlowDowns;

/// Appends a brake that takes the jerk to zero, ramps to a steady deceleration, holds it, and ramps back to zero. Its
/// ramps are the shortest ones that the limits on jerk allow, kMinDuration at least. For the jerk to go to zero, it
/// tries kSettleTime, halved up to kSettleHalvings times, and takes the time with the shortest way to rest. The brake
/// never takes the acceleration to zero before the ramp: at its speed limit, a vehicle whose speed still rises must not
/// wait.
///
/// False if there is no room, or if no such brake keeps the limits.
bool append_sharp_stop(const JointState& from, const MotionLimits& limits, Trajectory& out) noexcept;

/// The price of a brake straight ahead: three segments, and the peaks of their derivatives.
constexpr Operations kBrakeOperations = 28 * ops::kCurve;
/// The price of append_flat_stop() with a limit on jerk: seven times to settle, each with a search for the sharpest
/// ramp. Without one, a quarter.
constexpr Operations kFlatStopOperations = 300 * ops::kCurve;

/// The same with flatter ramps: where only the limit on jerk makes them long, they are a fifth shorter.
bool append_flat_stop(const JointState& from, const MotionLimits& limits, Trajectory& out) noexcept;

/// Appends a push to a side, a unit vector, with all the acceleration that the limits allow there, then the stop with
/// flat ramps. From rest, the stop ends about `far` metres away; with a limit on jerk, further. False if there is no
/// room, or if the limits do not hold.
bool append_push(const JointState& from, const MotionLimits& limits, const Vec3& side, double far,
                 Trajectory& out) noexcept;

/// How long slow-down `way` of 0 .. kSlowDowns - 1 takes from this velocity, seconds. On a straight path flown at a
/// constant speed, the sharpest one brakes at the limit of acceleration or of jerk.
double slow_down_time(const Vec3& velocity, const MotionLimits& limits, int way) noexcept;

/// Appends the plan's path from `from` on, flown ever slower until it rests after `time` > 0: if the path is clear, so
/// is the brake. It begins in the plan's state, from position to jerk, and ends half of `time` further along the plan,
/// or at its end. Every joint lies on the path; in between, the error is below kProofTolerance for common limits. The
/// caller has to check the limits. False if there is no room (kMaxSegments).
bool append_slow_down(const Trajectory& plan, double from, double time, Trajectory& out) noexcept;

}  // namespace tern

#endif
