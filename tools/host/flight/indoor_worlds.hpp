// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_INDOOR_WORLDS_HPP
#define TERN_HOST_FLIGHT_INDOOR_WORLDS_HPP

#include <string>

#include "host/flight/noise.hpp"

namespace tern_host {

/// One world under a roof, as records of its file: W, U, N, Q or X (docs/simulator.md).
std::string indoor_text(char family, Noise& random);

}  // namespace tern_host

#endif
