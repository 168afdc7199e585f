// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A way for flights that begin or end faster than the path's first or last polyhedron has room for: along the motion to
// where it can stop, and from there to the path.
#ifndef TERN_PLANNER_DETOUR_HPP
#define TERN_PLANNER_DETOUR_HPP

#include <cstdint>

#include "base/bounds.hpp"
#include "curve/brake.hpp"
#include "fence/fences.hpp"
#include "tern/grid.hpp"
#include "tern/path.hpp"
#include "tern/request.hpp"

namespace tern {

/// Report::detours of a plan that took one.
constexpr std::int32_t kDetoured = 1;

/// Waypoints that a stopping point may lead on to, counted from its end of the path.
constexpr int kOnwardWaypoints = 4;

/// Lines that the detours of both ends check at most.
constexpr std::uint32_t kDetourLines = 2u * static_cast<std::uint32_t>(kBrakeShapes + kOnwardWaypoints);

/// Leads each end of the path that moves through a point where that motion can stop (the goal's: where it can have
/// begun), if the straight way there keeps the radius: from there on to the furthest waypoint in sight, or back and
/// along the path. Adds two waypoints an end at most. False with `path` unchanged where neither end has such a point,
/// or there is no room for it. The request is in the local frame,
/// `limits` are its own; `fences` null for none. `lines`: how many were checked, <= kDetourLines.
bool take_detour(const Grid& grid, const Fences* fences, const Request& request, const MotionLimits& limits, Path& path,
                 std::uint32_t& lines) noexcept;

}  // namespace tern

#endif
