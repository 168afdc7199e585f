// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_MISSION_WORLDS_HPP
#define TERN_HOST_FLIGHT_MISSION_WORLDS_HPP

#include <string>

#include "host/flight/noise.hpp"

namespace tern_host {

/// Boundary, obstacles, start, vias and goal of one mission, as records of its file: L survey lines, G a lap through
/// ten gates, I an inspection round a tower, D a delivery there and back.
std::string mission_text(char family, Noise& random);

}  // namespace tern_host

#endif
