// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Holds a flight to the seven invariants of docs/flight.md at every tick. It knows the interface alone, and shares no
// code with what it watches.
#ifndef TERN_HOST_FLIGHT_FLIGHT_WATCH_HPP
#define TERN_HOST_FLIGHT_FLIGHT_WATCH_HPP

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "host/flight/curve_pieces.hpp"
#include "host/flight/flight_world.hpp"
#include "host/flight/rooms.hpp"
#include "tern/flight.hpp"

namespace tern_host {

/// What a flight commands.
struct FlownCommands {
  Commands at;
  std::function<tern::Vec3()> rest_position;
};
FlownCommands commands_of(const tern::Flight& flight);

/// What was looked at, and the largest snap and the number of slivers (curve_pieces.hpp) that were seen.
struct WatchCounts {
  std::uint64_t ticks = 0, commits = 0, points = 0, slivers = 0;
  double snap = 0.0;
};

class FlightWatch {
 public:
  /// All must outlive the watch, and what the commands come from.
  FlightWatch(const FlightWorld& world, const tern::FlightSpec& spec, const tern::RollingMap& map,
              FlownCommands commands);

  /// To be called right before and right after every tick. Ticks may be skipped.
  void before(std::int64_t t);
  void look(std::int64_t t, const tern::FlightReport& report);
  /// From now on, the map's world is not the true one: poses are off by more than their margin.
  void forget_world() { knows_world_ = false; }
  /// The first invariant that did not hold, with what was seen; empty while all hold.
  const std::string& broken() const { return broken_; }
  const WatchCounts& counts() const { return counts_; }
  const Rooms& rooms() const { return rooms_; }

 private:
  tern::Sample at(std::int64_t t) const { return commands_.at(t); }
  void fail(int invariant, const std::string& what, std::int64_t t);
  void check_report(const tern::FlightReport& report, std::int64_t t);
  void check_unchanged(std::int64_t t);
  void take_commit(std::int64_t t, bool proven);
  std::vector<TimedSample> sample_to_rest(std::int64_t t);
  void check_before_takeover(std::int64_t t);
  void check_joints(std::int64_t t, std::int64_t end);
  void check_curve(const std::vector<TimedSample>& fresh, std::int64_t t);
  std::int64_t unchanged_until(const std::vector<TimedSample>& fresh) const;
  void check_clear(std::int64_t from, std::int64_t fresh, std::int64_t to, bool proven);
  std::string too_near(const tern::Vec3& p, double room) const;
  void check_window(std::int64_t t);
  void note_place(std::int64_t t, std::int64_t changed, bool proven);
  std::int64_t longest_lead() const;
  std::int64_t time_for(double way, const tern::Sample& sample) const;

  const tern::FlightSpec& spec_;
  FlownCommands commands_;
  Rooms rooms_;
  bool knows_world_ = true;
  std::vector<TimedSample> near_;  ///< what is committed up to the next tick, before this one
  std::deque<TimedSample> ahead_;  ///< what is committed, a tick apart, up to the rest
  tern::FlightReport last_{};
  tern::Vec3 origin_{};  ///< of the window
  WatchCounts counts_;
  std::string broken_;
};

}  // namespace tern_host

#endif
