// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Intruders: aircraft that are no members of the fleet, send nothing, and cross the area. Every vehicle is told of each
// as `tern fly` tells of things that move.
#ifndef TERN_HOST_SWARM_SWARM_INTRUDERS_HPP
#define TERN_HOST_SWARM_SWARM_INTRUDERS_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "host/swarm/swarm_watch.hpp"
#include "host/swarm/swarm_world.hpp"
#include "host/things/detector.hpp"
#include "host/things/thing_motion.hpp"
#include "tern/flight.hpp"

namespace tern_host {

/// A flight has room for so many, and for as many plans of others.
constexpr int kMostIntruders = tern::kMaxFlightTracks / 2;

struct IntruderSettings {
  int count = 0;              ///< at most kMostIntruders
  double speed = 0.0;         ///< m/s, of the fastest one; 0: half of what the vehicles may do on an axis
  double acceleration = 2.0;  ///< m/s^2, > 0, with which they turn
  double bounds = 1.0;        ///< what vehicles are told of a speed and acceleration, as a part of what is true; > 0
};

/// Puts intruders into a world. Each is a ball that flies level at the height of some vehicle's start, give or take
/// half a metre, to and fro across the area, through a point where it turns, with half the speed or more. It begins
/// somewhere on its way, 2 m from all starts, and touches nothing that stands still; it enters and leaves through the
/// walls. Throws std::runtime_error if there are too many, or no such way is found.
void add_intruders(SwarmWorld& world, const IntruderSettings& settings, std::uint64_t seed);

/// The lines of docs/formats.md, without their ends.
std::vector<std::string> lines_of(const std::vector<Thing>& things);
/// Where all are at t ns.
std::vector<tern::Vec3> places_of(const std::vector<ThingMotion>& motions, std::int64_t t);
/// Tells a watch of a world's intruders.
void watch_intruders(const SwarmWorld& world, SwarmWatch& watch);

/// Tells one vehicle's flight of all intruders, wherever they are.
class IntruderReports {
 public:
  /// `begin`: of the flight, ns: the world's time 0. `tick`: FlightSpec::tick. Throws std::runtime_error if there are
  /// more than kMostIntruders.
  IntruderReports(const SwarmWorld& world, std::uint64_t seed, std::int64_t begin, std::int64_t tick);
  IntruderReports(const IntruderReports&) = delete;
  IntruderReports& operator=(const IntruderReports&) = delete;
  /// Before a tick of the flight at `time`, with the vehicle at `place`.
  void tell(std::int64_t time, const tern::Vec3& place, tern::Flight& flight);

 private:
  FlightWorld seen_;
  std::vector<ThingMotion> motions_;
  Detector detector_;
  FlightTape tape_{nullptr, 0};  ///< not used: what a swarm records is enough to fly it again
  std::int64_t last_tick_, tick_;
};

}  // namespace tern_host

#endif
