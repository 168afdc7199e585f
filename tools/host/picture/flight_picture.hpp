// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_PICTURE_FLIGHT_PICTURE_HPP
#define TERN_HOST_PICTURE_FLIGHT_PICTURE_HPP

#include <string>

#include "host/flight/simulated_flight.hpp"

namespace tern_host {

/// A flight as SVG: its figures, and top and side view with the true world, the way flown and the commits.
std::string flight_svg(const FlightWorld& world, const FlightResult& result);

}  // namespace tern_host

#endif
