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

/// Called after each tick with its time and what the flight commands then.
using OnTick = std::function<void(std::int64_t t, const tern::Command& command)>;

/// Throws std::runtime_error, with the reason, for bytes that are no record of a flight that this build can read.
FlightReplay replay_flight(const std::string& bytes, const OnTick& on_tick = {});

}  // namespace tern_host

#endif
