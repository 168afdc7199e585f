// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_THINGS_JSON_HPP
#define TERN_HOST_FLIGHT_THINGS_JSON_HPP

#include <nlohmann/json.hpp>

#include "host/flight/simulated_flight.hpp"

namespace tern_host {

/// What the flight was told of things that move, and its contacts with them.
nlohmann::ordered_json things_json(const FlightWorld& world, const FlightResult& result);

}  // namespace tern_host

#endif
