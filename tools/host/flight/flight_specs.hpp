// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a flight's settings mean to the map and to the flight.
#ifndef TERN_HOST_FLIGHT_FLIGHT_SPECS_HPP
#define TERN_HOST_FLIGHT_FLIGHT_SPECS_HPP

#include "host/flight/flight_world.hpp"
#include "tern/flight.hpp"

namespace tern_host {

/// The window around the start; from below the floor to above the ceiling, where that is within its height.
tern::MapSpec map_spec_of(const FlightWorld& world);

/// What the vehicle's sensor sees, without the further cameras.
tern::FlightSensor flight_sensor_of(const FlightSettings& settings);

/// Without fences.
tern::FlightSpec flight_spec_of(const FlightSettings& settings);

/// What is too near to a start that is refused, and how far it must be: goes on after the status. Empty where nothing
/// is.
std::string describe_refusal(const tern::FlightRefusal& refusal);

/// Throws where plans would not end within the window, or where the flight could not be at its start, its goal or a via
/// (clear_ends.hpp); says what to change.
void check_world(const FlightWorld& world, const tern::FlightSpec& spec, const tern::MapSpec& map);

/// How the flight plans its yaw, from the heading at the start on, rad.
tern::FlightYaw flight_yaw_of(const FlightSettings& settings, double start);

}  // namespace tern_host

#endif
