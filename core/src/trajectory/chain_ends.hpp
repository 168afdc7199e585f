// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Changes to a chain that its trajectory needs: at ends that move, of very short segments, and to follow the fallback.
#ifndef TERN_TRAJECTORY_CHAIN_ENDS_HPP
#define TERN_TRAJECTORY_CHAIN_ENDS_HPP

#include "base/bounds.hpp"
#include "tern/corridor.hpp"
#include "tern/request.hpp"
#include "tern/trajectory.hpp"
#include "times/chain.hpp"

namespace tern {

/// At an end, half of the control points follow from the boundary state alone, and so do those of the hodographs there.
/// Shortens the first and the last segment until these points keep the polyhedra and the limits. Likewise shortens
/// segments that meet at a via with a velocity. No segment becomes shorter than kMinDuration. No effect on ends at
/// rest. Returns how many durations it tried.
int fit_ends(const Corridor& corridor, const MotionLimits& limits, Chain& chain) noexcept;

/// Lengthens segments that are much shorter than the mean. Otherwise the Hessian of a long chain is too nearly
/// singular.
void even_out(Chain& chain) noexcept;

/// Gives the chain the segments and durations of a plan from its start to its goal. The plan must stay in its polyhedra
/// and within the limits, so a programme over these segments has a solution. Segments from rest to rest become two
/// halves, which gives the programme freedom there, if kMaxSegments allows it. Start, goal and centre stay.
void follow(const Trajectory& plan, Chain& chain) noexcept;

}  // namespace tern

#endif
