// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_CLEAR_ENDS_HPP
#define TERN_HOST_FLIGHT_CLEAR_ENDS_HPP

#include "host/flight/flight_world.hpp"
#include "tern/vec3.hpp"

namespace tern_host {

/// Throws RecordError where no flight with these settings could be at the start, reach the goal or pass a via: the
/// point is outside the boundary, or nearer than radius_of() to a wall, an obstacle, or a voxel that holds a part of
/// one; or it breaks a fence. It says what is too near, where, how far it is and how far it must be. `origin` is a
/// corner of any of the map's voxels. A goal that `goal_place` moves, and vias that may be skipped, are not looked at;
/// nor are obstacles that appear later.
void refuse_occupied_ends(const FlightWorld& world, const tern::Vec3& origin);

}  // namespace tern_host

#endif
