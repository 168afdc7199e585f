// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Braking along a trajectory's own path: if the path is clear, so is the brake.
#ifndef TERN_FLIGHT_SLOW_DOWN_HPP
#define TERN_FLIGHT_SLOW_DOWN_HPP

#include "base/bounds.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// How many slow-downs are tried, the sharpest first.
constexpr int kSlowDowns = 6;

/// How long slow-down `way` of 0 .. kSlowDowns - 1 takes from this velocity, seconds. On a straight path flown at a
/// constant speed, the sharpest one brakes at the limit of acceleration or of jerk.
double slow_down_time(const Vec3& velocity, const MotionLimits& limits, int way) noexcept;

/// Appends the plan's path from `from` on, flown ever slower until it rests after `time` > 0. It begins in the plan's
/// state, from position to jerk, and ends half of that time further along the plan, or at its end. Every joint lies on
/// the path; in between, the error is below kProofTolerance for common limits. The caller has to check the limits.
/// False if there is no room (kMaxSegments). Positions are relative to `out.origin`.
bool append_slow_down(const Trajectory& plan, double from, double time, Trajectory& out) noexcept;

}  // namespace tern

#endif
