// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The records of a flight's faults.
#ifndef TERN_HOST_FLIGHT_FAULT_RECORDS_HPP
#define TERN_HOST_FLIGHT_FAULT_RECORDS_HPP

#include "host/flight/setting_readers.hpp"

namespace tern_host {

/// Adds the settings that are faults.
void add_fault_setters(Setters& setters);

/// Reads `appear T block ...` or `appear T cylinder ...`. Throws RecordError.
Appearance read_appearance(const Words& words, const Place& place);

/// The numbers of a cylinder's record. Throws RecordError.
Cylinder read_cylinder(const Words& words, const Place& place);

/// Moves the goal as goal_place says. Throws RecordError where it cannot.
void place_goal(FlightWorld& world, const Place& place);

}  // namespace tern_host

#endif
