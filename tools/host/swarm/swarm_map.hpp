// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The map of a vehicle that knows its world.
#ifndef TERN_HOST_SWARM_SWARM_MAP_HPP
#define TERN_HOST_SWARM_SWARM_MAP_HPP

#include <vector>

#include "host/swarm/swarm_vehicle.hpp"
#include "host/swarm/swarm_world.hpp"
#include "tern/map.hpp"

namespace tern_host {

/// Holds the world, or what is around the vehicle's task.
tern::MapSpec map_spec_of(const SwarmWorld& world, const SwarmTask& task, const SwarmSettings& settings);
/// The slabs around the boundary, which are walls.
std::vector<tern::Box> walls_of(const SwarmWorld& world);

}  // namespace tern_host

#endif
