// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_PEOPLED_WORLDS_HPP
#define TERN_HOST_FLIGHT_PEOPLED_WORLDS_HPP

#include <string>

#include "host/flight/noise.hpp"

namespace tern_host {

/// Worlds with people, cars or birds: CW, RX and MF.
std::string peopled_text(const std::string& family, Noise& random);

}  // namespace tern_host

#endif
