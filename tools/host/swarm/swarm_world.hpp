// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Scenes with many vehicles: where each begins and ends, what stands still, and how they may fly. Published ones are as
// in the papers of those who fly them.
#ifndef TERN_HOST_SWARM_SWARM_WORLD_HPP
#define TERN_HOST_SWARM_SWARM_WORLD_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "host/things/thing.hpp"
#include "tern/grid.hpp"
#include "tern/request.hpp"
#include "tern/vec3.hpp"
#include "tern/via.hpp"

namespace tern_host {

/// One vehicle's task.
struct SwarmTask {
  tern::Vec3 start{};
  std::vector<tern::Via> mission;  ///< the last point is the goal
  double depart = 0.0;             ///< s: when it gets its mission
  std::uint8_t priority = 0;
};

struct SwarmWorld {
  std::string name;
  tern::Box boundary{};  ///< its faces are walls
  std::vector<tern::Box> blocks;
  std::vector<SwarmTask> tasks;
  std::vector<Thing> intruders;  ///< balls that are no members; walks or trefoils
  tern::Limits limits{};
  double body_radius = 0.25;  ///< m
  double cell = 0.25;         ///< m, of the maps
  double horizon = 8.0;       ///< m, of plans
  double time_limit = 60.0;   ///< s
  double around = 0.0;        ///< m: a map holds what is that near to the vehicle's task; 0: the whole world
};

/// What `swarm_world` takes, one line a family.
std::string swarm_families();

/// The world that a name such as "T3-10:1" gives: a family and a seed. Throws std::runtime_error for any other name.
SwarmWorld swarm_world(const std::string& name);

/// Distance of a point from the nearest block or wall, m; negative outside the boundary.
double swarm_clearance(const SwarmWorld& world, const tern::Vec3& point);

}  // namespace tern_host

#endif
