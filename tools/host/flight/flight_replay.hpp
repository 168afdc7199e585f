// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A recorded flight, flown again: the same calls of a map and a flight, and what each tick commanded compared with what
// the record says.
#ifndef TERN_HOST_FLIGHT_FLIGHT_REPLAY_HPP
#define TERN_HOST_FLIGHT_FLIGHT_REPLAY_HPP

#include <cstdint>
#include <functional>
#include <string>

#include "tern/flight.hpp"

namespace tern {
class FlightState;
}

namespace tern_host {

struct FlightReplay {
  std::uint64_t configuration = 0;  ///< configuration_hash() of the library that recorded
  int frames = 0;                   ///< with scans
  int ticks = 0;
  int different_ticks = 0;
  double seconds = 0.0;    ///< from the first tick to the last
  std::string difference;  ///< the first one; empty where all bits are equal
};

/// True for bytes that say that they are the record of a flight.
bool is_flight_record(const std::string& bytes);

/// What there is after a tick.
struct ReplayedTick {
  std::int64_t t;
  const tern::FlightReport& report;
  const tern::Command& command;  ///< for t
  const tern::MapSpec& map_spec;
  const tern::FlightSpec& spec;
  tern::Vec3 goal;  ///< that was told last
  const tern::RollingMap& map;
  const tern::Flight& flight;
  const tern::Planner& planner;
  const tern::FlightState& state;  ///< the flight's own, for displays
};
using OnTick = std::function<void(const ReplayedTick& tick)>;

/// Throws std::runtime_error, with the reason, for bytes that are no record of a flight that this build can read.
FlightReplay replay_flight(const std::string& bytes, const OnTick& on_tick = {});

}  // namespace tern_host

#endif
