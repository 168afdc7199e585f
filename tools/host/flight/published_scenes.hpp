// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Scenes among moving things that are published with other planners.
#ifndef TERN_HOST_FLIGHT_PUBLISHED_SCENES_HPP
#define TERN_HOST_FLIGHT_PUBLISHED_SCENES_HPP

#include <cstdint>
#include <string>

#include "host/flight/noise.hpp"

namespace tern_host {

/// MADER's corridor with so many things: 65 % cubes on trefoils, the others bars that swing up and down.
std::string mader_text(int things, Noise& random);
/// DYNUS's twenty cubes on trefoils, from Python's random.seed(seed).
std::string dynus_text(std::uint32_t seed);
/// SANDO's corridor with so many obstacles: 65 % cubes on trefoils, the others bars at rest. Likewise.
std::string sando_text(int obstacles, std::uint32_t seed);

}  // namespace tern_host

#endif
