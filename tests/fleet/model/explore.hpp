// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ways through the worlds: all of them, or some at random.
#ifndef TERN_TESTS_FLEET_MODEL_EXPLORE_HPP
#define TERN_TESTS_FLEET_MODEL_EXPLORE_HPP

#include "fleet/model/worlds.hpp"

namespace tern_model {

/// What an exploration saw.
struct Seen {
  std::size_t worlds = 0;
  std::size_t fleets = 0;
  int depth = 0;                      ///< all worlds that so many steps lead to were looked at
  bool is_whole = false;              ///< no step leads to another world
  int unsafe_depth = -1;              ///< steps to the first world in which two vehicles do not keep apart
  std::size_t stuck = 0;              ///< worlds from which not everyone gets a plan through
  std::size_t flown[kVehicles] = {};  ///< worlds in which the vehicle flies another plan than its first
};

/// Explores until `most` worlds are known, and looks at every `sample`th for progress.
inline Seen explore(const Setting& setting, std::size_t most, std::size_t sample) {
  Worlds worlds(setting);
  std::unordered_set<World, HashOfWorld> known;
  const World first = worlds.start();
  std::vector<World> level{first};
  std::vector<World> after;
  known.insert(first);
  Seen seen;
  while (!level.empty() && known.size() < most && seen.unsafe_depth < 0) {
    std::vector<World> next_level;
    for (const World& world : level) {
      for (int v = 0; v < setting.vehicles; ++v) seen.flown[v] += worlds.flown(world, v) != worlds.flown(first, v);
      if (!worlds.is_safe(world) && seen.unsafe_depth < 0) seen.unsafe_depth = seen.depth;
      if (seen.worlds++ % sample == 0 && !worlds.is_alive(world)) ++seen.stuck;
      worlds.next(world, after);
      for (const World& next : after) {
        if (known.insert(next).second) next_level.push_back(next);
      }
    }
    level.swap(next_level);
    ++seen.depth;
  }
  seen.is_whole = level.empty();
  seen.fleets = worlds.fleets();
  return seen;
}

/// What walks through the worlds saw.
struct Walked {
  int unsafe = 0;                     ///< walks that came to a world in which two vehicles do not keep apart
  int stuck = 0;                      ///< walks after which not everyone gets a plan through
  std::size_t taken[kVehicles] = {};  ///< plans
  std::size_t worlds = 0;
};

/// Goes `steps` steps at random from the start, again and again: deeper than all worlds can be looked at.
inline Walked walk(const Setting& setting, int walks, int steps, std::uint64_t seed) {
  Walked walked;
  tern_test::Random random(seed);
  auto worlds = std::make_unique<Worlds>(setting);
  for (int k = 0; k < walks; ++k) {
    if (k % 100 == 99) worlds = std::make_unique<Worlds>(setting);  // what is kept takes room
    World world = worlds->start();
    bool is_safe = true;
    for (int step = 0; step < steps && is_safe; ++step) {
      const World before = world;
      worlds->stray(world, random);
      for (int v = 0; v < setting.vehicles; ++v) walked.taken[v] += worlds->flown(world, v) != worlds->flown(before, v);
      is_safe = worlds->is_safe(world);
      ++walked.worlds;
    }
    walked.unsafe += is_safe ? 0 : 1;
    walked.stuck += worlds->is_alive(world) ? 0 : 1;
  }
  return walked;
}

}  // namespace tern_model

#endif
