// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the operator of a simulated flight may say of the space around the start.
#ifndef TERN_HOST_FLIGHT_ASSUMED_BALL_HPP
#define TERN_HOST_FLIGHT_ASSUMED_BALL_HPP

#include <vector>

#include "host/flight/flight_world.hpp"
#include "tern/grid.hpp"
#include "tern/vec3.hpp"

namespace tern_host {

/// For RollingMap::assume_free(): world frame, metres.
struct AssumedBall {
  tern::Vec3 center;
  double radius;
};

/// Radius of a ball around the start for RollingMap::assume_free(), metres: `most`, or less if a voxel wholly inside
/// that ball holds part of an obstacle or of a wall. No voxel wholly inside the smaller ball does.
double assumed_radius(const FlightWorld& world, const tern::GridSpec& grid, double most);

/// A ball around the start, of the radius that is kept and six voxels, or less as above. If that is too small for the
/// sensor, which sees what lies above and below the way only from afar, there are more: along 16 level directions, as
/// far as the vehicle could be carried, up to the distance that the sensor needs.
std::vector<AssumedBall> assumed_balls(const FlightWorld& world, const tern::GridSpec& grid);

}  // namespace tern_host

#endif
