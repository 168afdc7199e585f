// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_FAMILY_WORLDS_HPP
#define TERN_HOST_FLIGHT_FAMILY_WORLDS_HPP

#include <string>

#include "host/flight/noise.hpp"

namespace tern_host {

/// Boundary, obstacles, start and goal of one world, as records of its file.
std::string obstacles_text(const std::string& family, Noise& random);

}  // namespace tern_host

#endif
