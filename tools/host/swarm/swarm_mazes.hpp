// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_SWARM_SWARM_MAZES_HPP
#define TERN_HOST_SWARM_SWARM_MAZES_HPP

#include "host/flight/noise.hpp"
#include "host/swarm/swarm_world.hpp"

namespace tern_host {

/// Walls between the cells of a square about the origin, none nearer than `room` to a start or goal. Every cell can be
/// reached from every other one; of the walls that this allows, so large a part stands.
void add_maze(SwarmWorld& world, int cells, double cell, double part, double room, Noise& random);

}  // namespace tern_host

#endif
