// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Holds a flight to the seven invariants of docs/flight.md at every tick. It knows the interface alone, and shares no
// code with what it watches.
#ifndef TERN_HOST_FLIGHT_FLIGHT_WATCH_HPP
#define TERN_HOST_FLIGHT_FLIGHT_WATCH_HPP

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "host/flight/flight_world.hpp"
#include "tern/flight.hpp"

namespace tern_host {

/// What was looked at.
struct WatchCounts {
  std::uint64_t ticks = 0, commits = 0, points = 0;
};

class FlightWatch {
 public:
  /// All must outlive the watch.
  FlightWatch(const FlightWorld& world, const tern::FlightSpec& spec, const tern::RollingMap& map,
              const tern::Flight& flight);

  /// To be called after every tick.
  void look(std::int64_t t, const tern::FlightReport& report);
  /// The first invariant that did not hold, with what was seen; empty while all hold.
  const std::string& broken() const { return broken_; }
  const WatchCounts& counts() const { return counts_; }

 private:
  tern::Sample at(std::int64_t tick) const;
  void fail(int invariant, const std::string& what, std::int64_t t);
  void check_unchanged(std::int64_t t);
  void take_commit(std::int64_t t, bool proven);
  void check_before_takeover(const std::vector<tern::Sample>& fresh, std::int64_t t);
  void check_joints(const std::vector<tern::Sample>& fresh, std::int64_t t);
  void check_motion(const std::vector<tern::Sample>& fresh, std::int64_t t);
  void check_limits(const tern::Sample& sample, std::int64_t t);
  std::int64_t old_ticks(const std::vector<tern::Sample>& fresh) const;
  void check_clear(std::int64_t from, std::int64_t fresh, std::int64_t to);
  void check_window(std::int64_t t);
  void note_place();
  std::size_t lead_ticks() const;
  double solid_room(const tern::Vec3& p) const;
  double fence_room(const tern::Vec3& p) const;

  const FlightWorld& world_;
  const tern::FlightSpec& spec_;
  const tern::RollingMap& map_;
  const tern::Flight& flight_;
  double radius_;
  double speed_;                    ///< most that limits allow
  std::deque<tern::Sample> ahead_;  ///< what is committed, at the coming ticks, up to the rest
  std::uint32_t committed_ = 0;
  bool leaves_ = false;  ///< something is within the radius of where it rested last:
  tern::Vec3 left_{};    ///< this place
  tern::Vec3 origin_{};  ///< of the window
  WatchCounts counts_;
  std::string broken_;
};

}  // namespace tern_host

#endif
