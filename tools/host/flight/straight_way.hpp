// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_STRAIGHT_WAY_HPP
#define TERN_HOST_FLIGHT_STRAIGHT_WAY_HPP

#include "host/flight/flight_world.hpp"

namespace tern_host {

/// Seconds from start to goal, on straight lines from point to point of the mission, if nothing were in the way: each
/// line at the limit of the speed, with the limit of the acceleration at the start and at the goal. Turns, stops and
/// jerk cost nothing.
double straight_time(const FlightWorld& world);

}  // namespace tern_host

#endif
