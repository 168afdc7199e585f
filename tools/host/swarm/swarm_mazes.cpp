// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/swarm/swarm_mazes.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "host/flight/flight_world.hpp"

namespace tern_host {
namespace {

struct Door {
  int from, to;  ///< cells
  tern::Box wall;
};

/// A box between two points of the ground, 0.1 m thick, from floor to ceiling.
tern::Box wall_between(const SwarmWorld& world, double x0, double y0, double x1, double y1) {
  constexpr double kHalf = 0.05;
  return {{x0 - kHalf, y0 - kHalf, world.boundary.lower.z}, {x1 + kHalf, y1 + kHalf, world.boundary.upper.z}};
}

/// The one that stands for all cells that can be reached from this one.
int root_of(std::vector<int>& leads, int cell) {
  const auto next = [&](int at) -> int& { return leads[static_cast<std::size_t>(at)]; };
  while (next(cell) != cell) cell = next(cell) = next(next(cell));
  return cell;
}

/// All walls that there can be, in any order.
std::vector<Door> doors_of(const SwarmWorld& world, int cells, double cell, Noise& random) {
  std::vector<Door> doors;
  const double low = -0.5 * cells * cell;
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const double x = low + cell * i;
      const double y = low + cell * j;
      const int at = cells * j + i;
      if (i > 0) doors.push_back({at - 1, at, wall_between(world, x, y, x, y + cell)});
      if (j > 0) doors.push_back({at - cells, at, wall_between(world, x, y, x + cell, y)});
    }
  }
  for (std::size_t k = doors.size(); k-- > 1;) {
    std::swap(doors[k], doors[static_cast<std::size_t>(random.within(0.0, static_cast<double>(k)))]);
  }
  return doors;
}

}  // namespace

void add_maze(SwarmWorld& world, int cells, double cell, double part, double room, Noise& random) {
  std::vector<int> leads(static_cast<std::size_t>(cells * cells));
  for (std::size_t k = 0; k < leads.size(); ++k) leads[k] = static_cast<int>(k);
  for (const Door& door : doors_of(world, cells, cell, random)) {
    const int from = root_of(leads, door.from);
    const int to = root_of(leads, door.to);
    leads[static_cast<std::size_t>(from)] = to;
    const auto is_near = [&](const SwarmTask& task) {
      return distance_to(door.wall, task.start) < room || distance_to(door.wall, task.mission.back().position) < room;
    };
    const bool stands = from == to && random.chance(part);
    if (stands && std::none_of(world.tasks.begin(), world.tasks.end(), is_near)) world.blocks.push_back(door.wall);
  }
}

}  // namespace tern_host
