// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The corridor in the plan's own frame. A plan's coordinates are relative to its start, and its derivatives are
// differences of coordinates. So the rounding of both does not depend on the flight's place in the grid.
#ifndef TERN_TRAJECTORY_RELATIVE_CORRIDOR_HPP
#define TERN_TRAJECTORY_RELATIVE_CORRIDOR_HPP

#include "tern/corridor.hpp"
#include "times/chain.hpp"

namespace tern {

/// Metres by which a half-space moves in, if the segment of its polyhedron leaves that much room. A trajectory within
/// the trajectory stage's tolerance (kInsideTolerance) then stays within the corridor. A plan that began on the
/// corridor's surface would otherwise end a little outside it, and the next plan from there a little further.
constexpr double kCorridorReserve = 1e-9;

/// Fills `out` with the half-spaces and segment ends of `corridor` (local frame of the grid) relative to `origin`, a
/// point in the same frame. The first segment begins at `start` and the last ends at `goal`, bit for bit; both are
/// already relative to `origin`. Segments that meet at a via meet at its position, bit for bit. Each half-space
/// contains the ends of its segment exactly.
void relative_corridor(const Corridor& corridor, const Vec3& origin, const Vec3& start, const Vec3& goal,
                       const ViaJoints& via_joints, Corridor& out) noexcept;

}  // namespace tern

#endif
