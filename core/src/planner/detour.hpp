// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The attempt that follows if a plan begins or ends too fast for the first or last polyhedron. A detour leads along the
// motion to a point where it can stop, then from there to the path.
#ifndef TERN_PLANNER_DETOUR_HPP
#define TERN_PLANNER_DETOUR_HPP

#include <cstdint>

#include "base/bounds.hpp"
#include "base/progress.hpp"
#include "base/work.hpp"
#include "curve/brake.hpp"
#include "planner/problem.hpp"
#include "tern/grid.hpp"
#include "tern/path.hpp"
#include "tern/request.hpp"
#include "tern/status.hpp"
#include "world/world.hpp"

namespace tern {

/// From its stopping point, a detour goes on to one of this many waypoints, counted from its end of the path.
constexpr int kOnwardWaypoints = 4;

/// The most lines that the detours of both ends check.
constexpr std::uint32_t kDetourLines = 2u * static_cast<std::uint32_t>(kBrakeShapes + kOnwardWaypoints);

/// Changes the path at each end that is in motion. The path then first goes straight to a point where the motion can
/// stop (for the goal: where it can have begun), if this line keeps the radius. From there the path goes to the
/// furthest waypoint in sight, or back to its end and along the old path. Adds at most two waypoints per end. False,
/// with `path` unchanged, if neither end has such a point or the path has no room for it. The request is in the local
/// frame, and `limits` are its limits. A piece of work: at most kDetourLines lines.
bool take_detour(const World& world, const Request& request, const MotionLimits& limits, Path& path,
                 Work& work) noexcept;

struct Detour {
  bool tried;      ///< for the current goal
  Status without;  ///< why there is no trajectory without it
};

/// True if a detour may help after the trajectory stage failed: none was tried for the current goal, and there are no
/// vias.
bool detour_may_help(const Problem& problem, const Detour& detour) noexcept;

/// Begins the attempt. `why`: the status of the plan without a detour.
void detour_begin(Status why, Detour& detour) noexcept;
/// A piece of work makes the detours of both ends. kDone: the path has changed. kFailed: it has not.
Progress detour_advance(const Problem& problem, Path& path, Work& work) noexcept;

}  // namespace tern

#endif
