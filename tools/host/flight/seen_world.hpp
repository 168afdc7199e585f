// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_SEEN_WORLD_HPP
#define TERN_HOST_FLIGHT_SEEN_WORLD_HPP

#include "host/flight/flight_world.hpp"
#include "host/things/things_in_flight.hpp"

namespace tern_host {

/// What cameras and lidars see: the world, and the things that move in it where they are, if `things_seen` says so.
class SeenWorld {
 public:
  /// Both must outlive this.
  SeenWorld(const FlightWorld& truth, const ThingsInFlight& things)
      : truth_(truth), things_(things), with_things_(truth) {}

  /// The same object all the time.
  const FlightWorld& world() const { return sees_things() ? with_things_ : truth_; }
  /// To be called before every frame, at time t, ns.
  void move_to(std::int64_t t);

 private:
  bool sees_things() const { return truth_.settings.things_seen == 1 && !truth_.things.empty(); }

  const FlightWorld& truth_;
  const ThingsInFlight& things_;
  FlightWorld with_things_;
};

}  // namespace tern_host

#endif
