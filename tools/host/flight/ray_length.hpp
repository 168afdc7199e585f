// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_RAY_LENGTH_HPP
#define TERN_HOST_FLIGHT_RAY_LENGTH_HPP

#include "host/flight/flight_world.hpp"

namespace tern_host {

/// From an eye in free space to what a thin ray meets first, metres, along `along`, of length 1.
double ray_length(const FlightWorld& world, const tern::Vec3& eye, const tern::Vec3& along);

}  // namespace tern_host

#endif
