// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One flight through a world that the vehicle does not know, from rest to its end, and what is written about it.
#ifndef TERN_HOST_FLIGHT_SIMULATED_FLIGHT_HPP
#define TERN_HOST_FLIGHT_SIMULATED_FLIGHT_HPP

#include <array>
#include <cstdint>
#include <string>

#include "host/flight/flight_world.hpp"

namespace tern_host {

struct FlightResult {
  std::string status;  ///< reached, stuck, timeout, threat or collision
  double time = 0.0;   ///< seconds
  double length = 0.0;
  double min_clearance = 0.0;
  std::uint32_t asked = 0, committed = 0, dropped = 0, failed = 0;
  std::array<double, 5> seconds_in{};  ///< of each tern::FlightMode
  std::uint32_t work_max = 0, work_p99 = 0;
  std::uint64_t commands_hash = 0;
  std::string samples;  ///< CSV, one row a tick

  bool reached() const { return status == "reached"; }
};

/// Flies it. Throws std::runtime_error where the flight cannot begin.
FlightResult simulate_flight(const FlightWorld& world);

/// The log, as JSON (docs/formats.md).
std::string flight_json(const FlightWorld& world, const FlightResult& result);

}  // namespace tern_host

#endif
