// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The things that move in a simulated flight: where they are, what the flight is told of them, and contacts with them.
#ifndef TERN_HOST_THINGS_THINGS_IN_FLIGHT_HPP
#define TERN_HOST_THINGS_THINGS_IN_FLIGHT_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "host/flight/flight_contact.hpp"
#include "host/nanoseconds.hpp"
#include "host/things/detector.hpp"
#include "host/things/thing_watch.hpp"
#include "host/vehicle/vehicle.hpp"

namespace tern_host {

/// What a flight met among things that move.
struct ThingTotals {
  DetectorCounts detector;
  TrackingFigures tracking;  ///< if sensors are the detector
  std::vector<ThingContact> contacts;
  double step = 0.0;                            ///< s, from one place to the next
  std::vector<std::vector<tern::Vec3>> places;  ///< of each thing, from time 0 on

  int in_motion() const;
  int at_rest() const { return static_cast<int>(contacts.size()) - in_motion(); }
};

class ThingsInFlight {
 public:
  /// `world` must outlive this.
  explicit ThingsInFlight(const FlightWorld& world);

  /// At every tick: measures what is due.
  void sense(std::int64_t t, const Vehicle& vehicle);
  /// After every frame or scan that was taken, as Detector::see().
  template <typename Frame>
  void see(const Frame& frame, const tern::Vec3& eye, const tern::RollingMap& map) {
    detector_.see(frame, eye, map);
  }
  /// Before every tick that is done.
  void tell(std::int64_t t, tern::Flight& flight, FlightTape& tape) { detector_.deliver(t, flight, tape); }
  /// As Detector::explains().
  bool explains(const tern::Vec3& point, std::int64_t t, double room) const {
    return detector_.explains(point, t, room);
  }
  /// As Detector::meets().
  bool meets(const tern::Vec3& place, std::int64_t t) const { return detector_.meets(place, t); }
  /// After every tick that is done. `evades`: what was committed last was so under a threat.
  void note_tick(const tern::FlightReport& report, bool evades);
  /// Hunters choose what they do for the next `step`, ns.
  void hunt(std::int64_t t, std::int64_t step, const Vehicle& vehicle);
  /// When to look for contacts again, ns: at `end` at the latest.
  std::int64_t next(std::int64_t t, std::int64_t end) const { return watch_.next(t, end); }
  /// True where a contact begins.
  bool look(std::int64_t t, const Vehicle& vehicle, const tern::Sample& command);

  /// Where a thing is.
  tern::Vec3 place(std::size_t thing, std::int64_t t) const { return motions_[thing].at(seconds_of(t)).position; }
  ThingTotals totals() const { return {detector_.counts(), detector_.tracking(), watch_.contacts(), step_, places_}; }
  /// A contact in motion with a thing that kept its bounds, in words; empty while there is none.
  std::string broken() const;
  /// One with a thing that did not, or was not known: fills in `contact`. False while there is none.
  bool collides(FlightContact& contact) const;

 private:
  const FlightWorld& world_;
  std::vector<ThingMotion> motions_;
  Detector detector_;
  ThingWatch watch_;
  std::uint32_t committed_ = 0;
  double step_;
  std::vector<std::vector<tern::Vec3>> places_;
};

}  // namespace tern_host

#endif
