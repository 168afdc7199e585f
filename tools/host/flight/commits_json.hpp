// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_COMMITS_JSON_HPP
#define TERN_HOST_FLIGHT_COMMITS_JSON_HPP

#include <nlohmann/json.hpp>

#include "host/flight/simulated_flight.hpp"

namespace tern_host {

/// What `tern verify` proves of a flight (docs/formats.md): every committed plan with all its bits.
nlohmann::ordered_json commits_json(const FlightResult& result);
/// Where the vehicle was told to be, believed to be and was, at each tick.
nlohmann::ordered_json track_json(const FlightWorld& world, const FlightResult& result);
/// The world that it was flown in.
nlohmann::ordered_json true_world_json(const FlightWorld& world);

}  // namespace tern_host

#endif
