// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_OUTDOOR_WORLDS_HPP
#define TERN_HOST_FLIGHT_OUTDOOR_WORLDS_HPP

#include <string>

#include "host/flight/noise.hpp"

namespace tern_host {

/// One world under the sky, as records of its file: V, F, K, H, T30, E or R (docs/simulator.md).
std::string outdoor_text(const std::string& family, Noise& random);

}  // namespace tern_host

#endif
