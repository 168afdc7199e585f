// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Holds a mission to its promise: a point counts as passed only after the commands came within its tolerance, all
// points before it being done with.
#ifndef TERN_HOST_FLIGHT_MISSION_WATCH_HPP
#define TERN_HOST_FLIGHT_MISSION_WATCH_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "host/flight/curve_pieces.hpp"
#include "host/flight/simulated_flight.hpp"
#include "tern/flight.hpp"

namespace tern_host {

class MissionWatch {
 public:
  /// All must outlive the watch. `commands` has answers for the last tick's past, too.
  MissionWatch(const FlightWorld& world, const tern::Flight& flight, Commands commands);

  /// To be called after every tick.
  void look(std::int64_t t, const tern::FlightReport& report);
  /// The goal moved, before the tick at time `t`.
  void move_goal(const tern::Vec3& goal, std::int64_t t);
  /// The first thing that did not hold; empty while all holds.
  const std::string& broken() const { return broken_; }
  const std::vector<MissionPoint>& points() const { return points_; }

 private:
  void approach(std::int64_t from, std::int64_t to);
  void close(std::size_t point);

  const FlightWorld& world_;
  const tern::Flight& flight_;
  Commands commands_;
  std::vector<MissionPoint> points_;
  std::size_t leg_ = 0;  ///< the first one that is not done with
  std::int64_t last_ = 0;
  std::string broken_;
};

}  // namespace tern_host

#endif
