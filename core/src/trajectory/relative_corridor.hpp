// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The corridor in the plan's own frame. A plan's coordinates are relative to its start: what rounding does to them, and
// to the derivatives that are their differences, depends on the flight alone and not on where it lies in the grid.
#ifndef TERN_TRAJECTORY_RELATIVE_CORRIDOR_HPP
#define TERN_TRAJECTORY_RELATIVE_CORRIDOR_HPP

#include "tern/corridor.hpp"
#include "times/chain.hpp"

namespace tern {

/// Metres by which a half-space moves in, where the segment of its polyhedron leaves that much room: the tolerance that
/// the trajectory stage accepts (kInsideTolerance) then stays within the corridor. A plan that began on the corridor's
/// surface would otherwise end a little outside it, and the next plan from there a little further.
constexpr double kCorridorReserve = 1e-9;

/// Fills `out` with the half-spaces and segment ends of `corridor` (local frame of the grid) relative to `origin`, a
/// point in the same frame. The first segment begins at `start` and the last ends at `goal`, both relative to `origin`
/// already, bit for bit; so do those that meet at a hold, with its position. Each half-space holds the ends of its
/// segment exactly. Sets no redundant half-spaces and no ellipsoids.
void relative_corridor(const Corridor& corridor, const Vec3& origin, const Vec3& start, const Vec3& goal,
                       const Holds& holds, Corridor& out) noexcept;

}  // namespace tern

#endif
