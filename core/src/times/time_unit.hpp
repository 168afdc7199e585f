// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The speed and acceleration that a flight can reach, and the cost of a second at time weight 1, which follows from
// them.
#ifndef TERN_TIMES_TIME_UNIT_HPP
#define TERN_TIMES_TIME_UNIT_HPP

#include "base/bounds.hpp"
#include "tern/corridor.hpp"
#include "times/chain.hpp"
#include "times/trapezoid.hpp"

namespace tern {

/// The acceleration limit along the way, and the speed that the flight can reach; both > 0. The speed is the least of
/// three: the speed limit along the way, half the peak of the triangular profile along the whole way, and the peak of
/// that profile along a leg of mean length. A moving end adds the way that it takes to stop.
LineLimits reachable(const Chain& chain, const Corridor& corridor, const MotionLimits& limits) noexcept;

/// The length of a mean leg divided by the way that it takes to reach the speed of reachable() and to stop again, > 0.
/// At large values the speed limit decides how long a flight takes, and the acceleration limit hardly matters.
double agility(const Chain& chain, const Corridor& corridor, const MotionLimits& limits) noexcept;

/// The unit of Request::time_weight for this flight, m^2/s^8, > 0: a^6 / v^4, with acceleration and speed of
/// reachable(). So limits that the flight cannot reach have no influence.
double time_unit(const Chain& chain, const Corridor& corridor, const MotionLimits& limits) noexcept;

}  // namespace tern

#endif
