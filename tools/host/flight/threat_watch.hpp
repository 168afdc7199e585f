// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Holds a flight to what it promises in a world that changes: what comes into the way is a threat, the report says when
// and how fast it is met, and that is no faster than after an immediate brake.
#ifndef TERN_HOST_FLIGHT_THREAT_WATCH_HPP
#define TERN_HOST_FLIGHT_THREAT_WATCH_HPP

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "host/flight/flight_watch.hpp"
#include "host/flight/immediate_brake.hpp"
#include "host/flight/rooms.hpp"
#include "tern/flight.hpp"

namespace tern_host {

/// A contact with something that appeared. Speeds are the command's, m/s.
struct ThreatContact {
  bool shown = false;      ///< the map showed in time that something is in the way
  bool announced = false;  ///< the flight was under a threat
  double speed = 0.0;
  double announced_speed = 0.0;  ///< what the last report said of it
  double brake_speed = 0.0;      ///< after an immediate brake, at the same distance from the thing
  double tolerance = 0.0;        ///< by which the contact may be faster than either of the two
};

/// True if a vehicle at this place at time t, ns, is too near to the tube of a thing that the flight was told of.
using Meets = std::function<bool(const tern::Vec3& place, std::int64_t t)>;

class ThreatWatch {
 public:
  /// All must outlive the watch, and what the commands come from. `rooms` know where the vehicle rested.
  ThreatWatch(const FlightSettings& settings, const tern::FlightSpec& spec, const tern::RollingMap& map,
              const Rooms& rooms, FlownCommands commands, Meets meets);

  /// Right after a tick: after all from the first one on after which the world has changed or there is a threat.
  void look(std::int64_t t, const tern::FlightReport& report);
  /// The body touches `things` at time t.
  ThreatContact meet(std::int64_t t, const std::vector<Appearance>& things) const;
  /// The first promise that was broken; empty while all are kept.
  const std::string& broken() const { return broken_; }

 private:
  void fail(const std::string& what, std::int64_t t);
  void follow(std::int64_t t);
  std::int64_t first_unproven(std::int64_t t) const;
  void check_report(std::int64_t t, const tern::FlightReport& report);
  void check_past(std::int64_t t, const tern::FlightReport& report);
  bool meets_tube(std::int64_t t) const;
  std::int64_t notice_ticks() const;
  void count_disagreement(const tern::FlightReport& report, std::int64_t t);
  double brake_speed(const std::vector<Appearance>& things, double near) const;
  bool is_clear(const BrakeWay& way, const std::vector<Appearance>& things) const;

  const FlightSettings& settings_;
  const tern::FlightSpec& spec_;
  const tern::RollingMap& map_;
  const Rooms& rooms_;
  FlownCommands commands_;
  Meets meets_;
  std::uint64_t revision_ = 0;
  std::int64_t unproven_ = -1;  ///< when what is commanded comes too near to what the map shows; negative: never
  std::int64_t shown_ = -1;     ///< since when that is so
  std::vector<tern::Sample> shown_way_;         ///< what was commanded then, a millisecond apart, up to the rest
  bool said_ = false;                           ///< the flight said that something is in the way since it is
  std::int64_t unnoticed_ = 0, unfounded_ = 0;  ///< ticks in a row in which flight and watch do not agree
  tern::FlightReport last_{};
  std::string broken_;
};

}  // namespace tern_host

#endif
