// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the operator of a simulated flight may say of the space around the start.
#ifndef TERN_HOST_FLIGHT_ASSUMED_BALL_HPP
#define TERN_HOST_FLIGHT_ASSUMED_BALL_HPP

#include "host/flight/flight_world.hpp"
#include "tern/grid.hpp"

namespace tern_host {

/// Radius of a ball around the start for RollingMap::assume_free(), metres: `most`, or less if a voxel wholly inside
/// that ball holds part of an obstacle or of a wall. No voxel wholly inside the smaller ball does.
double assumed_radius(const FlightWorld& world, const tern::GridSpec& grid, double most);

}  // namespace tern_host

#endif
