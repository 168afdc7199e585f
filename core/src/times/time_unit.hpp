// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a flight can reach, and from that what its seconds are worth at time weight 1.
#ifndef TERN_TIMES_TIME_UNIT_HPP
#define TERN_TIMES_TIME_UNIT_HPP

#include "base/bounds.hpp"
#include "tern/corridor.hpp"
#include "times/chain.hpp"
#include "times/trapezoid.hpp"

namespace tern {

/// The acceleration limit along the way, and the speed that matters on it: the speed limit along the way, or what there
/// is room for if that is less. There is room for half the peak of the triangular profile along the whole way, and for
/// the whole peak of that along a leg of mean length. A moving end counts as the way that it takes to stop. Both > 0.
LineLimits reachable(const Chain& chain, const Corridor& corridor, const MotionLimits& limits) noexcept;

/// The length of a mean leg over the way that it takes to reach that speed and to stop again, > 0: at large values it
/// is the speed limit that decides how long a flight takes, and the acceleration limit hardly matters.
double agility(const Chain& chain, const Corridor& corridor, const MotionLimits& limits) noexcept;

/// The unit of Request::time_weight for this flight, m^2/s^8, > 0: a^6 / v^4 of what is reachable, so that limits have
/// no say that the flight cannot reach.
double time_unit(const Chain& chain, const Corridor& corridor, const MotionLimits& limits) noexcept;

}  // namespace tern

#endif
