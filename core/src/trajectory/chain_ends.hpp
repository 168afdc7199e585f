// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Changes to a chain that its trajectory asks for: at ends that move, and where the fallback shows the way.
#ifndef TERN_TRAJECTORY_CHAIN_ENDS_HPP
#define TERN_TRAJECTORY_CHAIN_ENDS_HPP

#include "base/bounds.hpp"
#include "tern/corridor.hpp"
#include "tern/request.hpp"
#include "tern/trajectory.hpp"
#include "times/chain.hpp"

namespace tern {

/// Shortens the first and the last segment until what follows from the boundary states alone (half of their control
/// points, and the hodographs' there) keeps the polyhedra and the limits; kMinDuration at least. Likewise those
/// that meet at a via with a velocity. No effect at rest. Returns how many lengths it tried.
int fit_ends(const Corridor& corridor, const MotionLimits& limits, Chain& chain) noexcept;

/// The segments of a plan that keeps everything, from the chain's start to its goal, with their durations: a programme
/// over them has a solution. Segments from rest to rest become halves, which gives the programme freedom there, as far
/// as kMaxSegments allows. Start, goal and centre stay.
void follow(const Trajectory& plan, Chain& chain) noexcept;

}  // namespace tern

#endif
