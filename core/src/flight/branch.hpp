// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pieces that committed plans are made of: the first part of a trajectory, a segment that takes the jerk to zero, and
// a brake in closed form. Every function appends to a trajectory; positions are relative to its origin.
#ifndef TERN_FLIGHT_BRANCH_HPP
#define TERN_FLIGHT_BRANCH_HPP

#include "base/bounds.hpp"
#include "curve/brake.hpp"
#include "curve/hermite.hpp"
#include "curve/stopping.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// The longest time in which the jerk goes to zero, seconds, and how often it may be halved so that the limits hold.
constexpr double kSettleTime = 0.05;
constexpr int kSettleHalvings = 5;

/// How long it takes from this state.
double settle_time(const JointState& from, const MotionLimits& limits) noexcept;
/// The state then: the jerk falls to zero at a constant rate.
JointState settled(const JointState& from, double time) noexcept;

/// Position to jerk of a trajectory, the position relative to `origin`.
JointState joint_at(const Trajectory& plan, double t, const Vec3& origin) noexcept;

/// `out` becomes what follows `t` of the plan, with the segments that begin in the next `ahead` seconds; rest at the
/// plan's end where nothing follows. 0 <= t.
void take_rest(const Trajectory& plan, double t, double ahead, Trajectory& out) noexcept;

/// Appends the segment between two states. False where there is no room: kMaxSegments.
bool append_between(const JointState& from, const JointState& to, double time, Trajectory& out) noexcept;

/// Seconds: in a shorter segment, the rounding of control points is tens of m/s^3 of jerk.
constexpr double kSliver = 1e-3;
/// The joint before `t` where that is nearer than kSliver, else `t`: a plan that is cut there ends in no sliver.
double off_joints(const Trajectory& plan, double t) noexcept;

/// `out` becomes the part of the plan before `t`, bit for bit but for its last segment. `t` > 0.
void take_first_part(const Trajectory& plan, double t, Trajectory& out) noexcept;

/// Takes the jerk to zero, which is sharper than a brake that goes on with it, and brakes straight ahead in way 0 ..
/// kStops - 1, sharp ones first. False where there is no room, or where the limits do not hold. `scratch` would be
/// large for the stack.
constexpr int kStops = kBrakeShapes;
bool append_stop(const JointState& from, const MotionLimits& limits, int way, Stopping& scratch,
                 Trajectory& out) noexcept;

}  // namespace tern

#endif
