// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One vehicle of a swarm: its map, its planner, its flight and its part in the fleet, on a clock of its own.
#ifndef TERN_HOST_SWARM_SWARM_VEHICLE_HPP
#define TERN_HOST_SWARM_SWARM_VEHICLE_HPP

#include <cstdint>
#include <memory>
#include <vector>

#include "host/swarm/links.hpp"
#include "host/swarm/swarm_intruders.hpp"
#include "host/swarm/swarm_sensor.hpp"
#include "host/swarm/swarm_traffic.hpp"
#include "host/swarm/swarm_world.hpp"
#include "tern/fleet.hpp"
#include "tern/flight.hpp"

namespace tern_host {

struct SwarmSettings {
  LinkSettings links;
  std::uint64_t seed = 1;  ///< of links and clocks
  int threads = 1;         ///< that compute; they change nothing
  double tick_hz = 50.0;
  double late = 0.0;         ///< s that ticks may be late, at most
  double send_hz = 20.0;     ///< rounds of packets that each vehicle sends
  int packet_bytes = 1400;   ///< the largest packet
  double clock_error = 0.0;  ///< s: clocks are off by up to half of it
  double restarts = 0.0;     ///< how often each vehicle begins anew in its fleet, per second
  double clearance = 0.0;    ///< s that a plan waits for answers at least; 0: from the delays of the links
  double tracking_margin = 0.02;
  double range = 0.0;     ///< m: only who is that near is a member of a vehicle's fleet; 0: all are
  double discover = 0.0;  ///< m: what stands still is found by lidars of this range; 0: all know it beforehand
  std::uint32_t work_per_tick = 16000;
  std::uint32_t fleet_work = 500;  ///< units a tick
};

/// What a vehicle's tick did.
struct SwarmTick {
  bool committed = false;
  bool unasked = false;           ///< it committed a plan that was not cleared: a brake
  bool agrees = true;             ///< it flies what the fleet says that it flies, but for a brake without agreement
  std::uint32_t fleet_units = 0;  ///< that Fleet::advance() took
  int members = 0;                ///< of its fleet, besides itself
  int untold = 0;                 ///< others' plans that the flight has no room for
};

/// m: how far a radio reaches at least, if members are those in `range`.
double swarm_radio(double range);

class SwarmVehicle {
 public:
  SwarmVehicle(const SwarmWorld& world, const SwarmSettings& settings, int number, std::int64_t clock_offset);

  /// Takes packets, ticks, and sends; `now` is true time, ns.
  SwarmTick tick(std::int64_t now, Carrier& carrier);
  /// Where it is at a time that is not before its last tick.
  tern::Sample at(std::int64_t now) const { return flight_.command(now + offset_).sample; }
  bool has_arrived() const { return report_.reason == tern::FlightReason::kArrived; }
  bool rests() const { return report_.mode == tern::FlightMode::kRest; }
  const tern::FlightReport& report() const { return report_; }
  tern::FleetReport fleet_report() const { return fleet_->report(); }
  std::uint32_t asked() const { return asked_; }

 private:
  void start_map(const SwarmTask& task);
  void begin_fleet(std::int64_t time);
  bool follows_proposed() const;
  void forget_question();
  std::int64_t least_patience() const;
  void set_patience(std::int64_t patience);
  bool agrees(std::int64_t time) const;
  void advance_fleet(std::int64_t time, SwarmTick& did);
  void advance_flight(std::int64_t time, SwarmTick& did);
  void announce(std::int64_t time);
  void hear_answer(std::int64_t time);
  void send(std::int64_t now, Carrier& carrier);

  const SwarmWorld& world_;
  const SwarmSettings& settings_;
  int number_;
  std::int64_t offset_;
  std::unique_ptr<tern::Workspace> memory_;
  tern::Planner planner_;
  std::vector<std::uint64_t> map_words_, flight_words_;
  tern::RollingMap map_;
  tern::FlightSpec spec_{};
  tern::Flight flight_;
  std::unique_ptr<tern::Fleet> fleet_;
  Noise restarts_;
  tern::FlightReport report_{};
  bool has_mission_ = false;
  std::uint32_t incarnation_ = 0;
  std::uint32_t asked_ = 0;      ///< the flight's question that the fleet was asked; 0: none
  bool answered_ = false;        ///< the flight was told that it may fly
  std::int64_t asked_at_ = 0;    ///< when
  std::int64_t patience_ = 0;    ///< how long plans wait for answers, ns
  std::uint32_t cleared_ = 0;    ///< the last question after which the flight committed its plan
  std::int64_t takeover_ = 0;    ///< of the plan that the fleet was asked about
  tern::Trajectory proposed_{};  ///< that plan
  bool pending_ = false;         ///< the flight committed it, and the fleet is yet to take it over
  bool begins_anew_ = false;     ///< the flight committed what the fleet did not agree to
  std::int64_t next_round_ = 0;
  SwarmTraffic traffic_;
  std::unique_ptr<SwarmSensor> sensor_;         ///< null: the world is known
  std::unique_ptr<IntruderReports> intruders_;  ///< null: there are none
};

}  // namespace tern_host

#endif
