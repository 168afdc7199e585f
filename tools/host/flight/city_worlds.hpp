// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_CITY_WORLDS_HPP
#define TERN_HOST_FLIGHT_CITY_WORLDS_HPP

#include <string>

#include "host/flight/noise.hpp"

namespace tern_host {

/// A delivery of 1 to 3 km below the roofs of a city, with a court of several blocks across the straight way.
std::string city_text(Noise& random);

}  // namespace tern_host

#endif
