// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The plan if optimising fails (contract C6): straight from waypoint to waypoint, at rest in each. It needs no solver:
// a straight segment stays in the polyhedron that was grown around it. A moving start is first braked, and a moving
// goal is reached by speeding up at the end, each inside its polyhedron if it has room.
#ifndef TERN_TRAJECTORY_STOP_AND_GO_HPP
#define TERN_TRAJECTORY_STOP_AND_GO_HPP

#include "base/bounds.hpp"
#include "tern/corridor.hpp"
#include "tern/request.hpp"
#include "tern/status.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// Duration of a plan whose start is its goal, seconds.
constexpr double kHoverDuration = 1.0;

/// Fills count and segments of `out`, and returns kOk. Otherwise `out` is untouched: kNoTrajectory if there is no room
/// to brake or accelerate, kSegmentsFull if the plan needs more segments than there are. Legs of length zero are left
/// out.
Status stop_and_go(const Corridor& corridor, const State& start, const State& goal, const MotionLimits& limits,
                   Trajectory& out) noexcept;

/// A plan for a start at rest that is its goal: stays for kHoverDuration.
void hover(const Vec3& point, Trajectory& out) noexcept;

}  // namespace tern

#endif
