// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A whole swarm in one process: vehicles, their links, and the watch.
#ifndef TERN_HOST_SWARM_SWARM_HPP
#define TERN_HOST_SWARM_SWARM_HPP

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "host/swarm/swarm_record.hpp"
#include "host/swarm/swarm_vehicle.hpp"
#include "host/swarm/swarm_watch.hpp"
#include "host/swarm/swarm_world.hpp"

namespace tern_host {

struct SwarmMember {
  double arrived = -1.0;  ///< s since it departed; negative: it did not
  double alone = 0.0;     ///< s: one plan without the others takes so long, if that was asked for
  double length = 0.0;    ///< m
  std::uint32_t commits = 0;
  std::uint32_t unasked = 0;  ///< plans that were not cleared: brakes
  std::string state;          ///< where it did not arrive: why
};

struct SwarmResult {
  std::vector<SwarmMember> members;
  std::vector<SwarmContact> contacts;
  std::vector<SwarmContact> touched_at_rest;           ///< by intruders
  double least_distance = 0.0, least_clearance = 0.0;  ///< m
  double least_gap = 0.0;                              ///< m, between a vehicle in motion and an intruder
  double time = 0.0;                                   ///< s that were simulated
  double computed = 0.0;                               ///< s of processor time
  std::uint64_t packets = 0, lost = 0, bytes = 0;
  std::uint32_t disagreed = 0;         ///< ticks at which a vehicle did not fly what its fleet said
  std::uint32_t most_fleet_units = 0;  ///< of a tick
  /// Work of all vehicles in all ticks; 0 of vehicles in processes.
  std::uint64_t fleet_units = 0, flight_units = 0;
  int most_members = 0;            ///< of a vehicle's fleet, at a time
  std::uint64_t member_ticks = 0;  ///< the same, summed over all vehicles and ticks
  std::uint64_t ticks = 0;         ///< of all vehicles
  int most_untold = 0;             ///< others' plans that a flight has no room for, at a time
  std::uint64_t hash = 0;          ///< of all positions at all ticks
  /// All members, one row each `film_step` seconds. Of vehicles in processes, places alone.
  std::vector<std::vector<tern::Sample>> film;
  std::vector<std::vector<tern::Vec3>> intruder_film;  ///< likewise, all intruders
  double film_step = 0.1;

  int arrived() const;
  double last_arrival() const;  ///< s; of those that arrived
  double mean_travel() const;   ///< s
};

/// Puts what a watch found into a result.
void take_findings(const SwarmWatch& watch, SwarmResult& result);

/// Flies until all have arrived, or the time limit. `progress` hears of the time, s, and how many arrived; may be null.
/// `record`: is written if it is not null.
SwarmResult fly_swarm(const SwarmWorld& world, const SwarmSettings& settings,
                      const std::function<void(double, int)>& progress = nullptr, SwarmRecord* record = nullptr);

}  // namespace tern_host

#endif
