// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What remains when optimising fails (contract C6): straight from waypoint to waypoint, at rest in each. Needs no
// solver and no luck: a straight segment stays in the polyhedron that was grown around it. A start or goal that moves
// is first braked (or last accelerated) inside its polyhedron, where that is possible.
#ifndef TERN_TRAJECTORY_STOP_AND_GO_HPP
#define TERN_TRAJECTORY_STOP_AND_GO_HPP

#include "base/bounds.hpp"
#include "tern/corridor.hpp"
#include "tern/request.hpp"
#include "tern/status.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// How long a plan lasts whose start is its goal, seconds.
constexpr double kHoverDuration = 1.0;

/// kOk, which fills count and segments of `out`. Otherwise `out` is untouched: kNoTrajectory if there is no room to
/// brake or accelerate, kSegmentsFull if there are too few segments for that. Legs of no length are left out.
Status stop_and_go(const Corridor& corridor, const State& start, const State& goal, const MotionLimits& limits,
                   Trajectory& out) noexcept;

/// A plan for a start at rest that is its goal: stays for kHoverDuration.
void hover(const Vec3& point, Trajectory& out) noexcept;

}  // namespace tern

#endif
