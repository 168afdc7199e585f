// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Families of worlds in which things move.
#ifndef TERN_HOST_FLIGHT_MOVING_WORLDS_HPP
#define TERN_HOST_FLIGHT_MOVING_WORLDS_HPP

#include <cstdint>
#include <string>

#include "host/flight/noise.hpp"

namespace tern_host {

/// True for the families that moving_text() knows.
bool is_moving_family(const std::string& family);

/// As obstacles_text(), with things that move. `random` belongs to the seed.
std::string moving_text(const std::string& family, std::uint64_t seed, Noise& random);

}  // namespace tern_host

#endif
