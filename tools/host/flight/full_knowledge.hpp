// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_FULL_KNOWLEDGE_HPP
#define TERN_HOST_FLIGHT_FULL_KNOWLEDGE_HPP

#include "host/flight/flight_world.hpp"
#include "tern/request.hpp"

namespace tern_host {

/// Least distance that the vehicle's command keeps from everything: body, tracking error and pose error.
double radius_of(const FlightSettings& settings);

/// The limits of the flight's plans.
tern::Limits limits_of(const FlightSettings& settings);

/// How long one plan from start to goal takes that knows the whole world, with the same voxels, radius and limits.
/// Seconds; 0 where the planner has none.
double full_knowledge_time(const FlightWorld& world);

}  // namespace tern_host

#endif
