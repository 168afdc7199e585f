// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a vehicle of a swarm spends in a tick, with ever more others.
#include <cstdio>
#include <fstream>
#include <string>

#include "host/swarm/swarm.hpp"
#include "scale_rows.hpp"

namespace tern_bench {
namespace {

const int kVehicles[] = {2, 5, 10, 20, 50, 100};
constexpr double kRange = 25.0;  ///< metres, of members by range

/// By list where `range` is 0.
void fly(int vehicles, double range, std::ofstream& csv) {
  const tern_host::SwarmWorld world = tern_host::swarm_world("plain-" + std::to_string(vehicles) + ":1");
  tern_host::SwarmSettings settings;
  settings.range = range;
  settings.threads = 2;
  const tern_host::SwarmResult result = tern_host::fly_swarm(world, settings);
  const auto ticks = static_cast<double>(result.ticks);
  const double flight = static_cast<double>(result.flight_units) / ticks;
  const double fleet = static_cast<double>(result.fleet_units) / ticks;
  const double members = static_cast<double>(result.member_ticks) / ticks;
  std::printf(
      "%d vehicles %s: %d arrived, %zu contacts; %.1f members; units a tick: flight %.0f, fleet %.1f, %u at most\n",
      vehicles, range > 0.0 ? "by range" : "by list", result.arrived(), result.contacts.size(), members, flight, fleet,
      result.most_fleet_units);
  csv << (range > 0.0 ? "vehicles by range," : "vehicles by list,") << vehicles << ',' << result.arrived() << ','
      << vehicles << ",0,0,0,0,0,0,0,0," << flight << ',' << fleet << '\n';
}

}  // namespace

void over_vehicles(std::ofstream& csv) {
  for (const double range : {0.0, kRange}) {
    for (const int vehicles : kVehicles) fly(vehicles, range, csv);
  }
}

}  // namespace tern_bench
