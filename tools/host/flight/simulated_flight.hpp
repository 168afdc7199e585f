// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One flight through a world that the vehicle does not know, from rest to its end, and what is written about it.
#ifndef TERN_HOST_FLIGHT_SIMULATED_FLIGHT_HPP
#define TERN_HOST_FLIGHT_SIMULATED_FLIGHT_HPP

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "host/flight/far_guide.hpp"
#include "host/flight/flight_contact.hpp"
#include "host/flight/flight_world.hpp"
#include "host/flight/narrow_place.hpp"
#include "host/things/things_in_flight.hpp"
#include "host/vehicle/vehicle.hpp"
#include "tern/flight.hpp"

namespace tern {
class FlightState;
}

namespace tern_host {

/// Where the vehicle was at one tick.
struct TrackPoint {
  tern::Vec3 position;   ///< in truth
  double speed;          ///< m/s
  bool committed;        ///< a plan was committed in this tick
  tern::Vec3 commanded;  ///< where the vehicle was told to be,
  tern::Vec3 believed;   ///< and where it believed to be
};

/// What was looked at to hold the flight to its invariants, and what was found: the largest snap, and slivers
/// (curve_pieces.hpp).
struct WatchTotals {
  std::uint64_t ticks = 0, commits = 0, points = 0, voxels = 0, hits = 0, slivers = 0;
  double snap = 0.0;
};

/// What became of a point of the mission; the goal is the last one.
struct MissionPoint {
  tern::Vec3 position;
  double tolerance;
  std::string state;             ///< ahead, passed or skipped
  double time, distance, speed;  ///< where the commands came nearest to it while it was ahead
};

constexpr std::int64_t kNotWithdrawn = -1;

/// m/s
constexpr double kStanding = 0.1;

/// A plan that was committed.
struct FlightCommit {
  std::int64_t time;       ///< nanoseconds, of the tick that committed it
  std::int64_t begin;      ///< nanoseconds, of the trajectory
  std::int64_t withdrawn;  ///< nanoseconds, of the tick that dropped it before it began; kNotWithdrawn if none did
  bool evades;             ///< under a threat: proven or not
  bool leaves;             ///< it leads away from something within the radius
  tern::Trajectory flown;
};

struct FlightResult {
  std::string status;                                      ///< reached, stuck, timeout, threat, collision or invariant
  std::string reason;                                      ///< in words
  tern::BlockedBy blocked_by = tern::BlockedBy::kNothing;  ///< at the end, as tern::FlightReport says,
  tern::Vec3 blocked_at{};                                 ///< and where
  std::int32_t blocked_fence = tern::kNoFence;
  std::vector<tern::UnseenVoxel> looked_in_vain;  ///< at the end, as tern::Flight says
  NarrowPlace narrow;                             ///< if the vehicle gave up and a voxel is in its way
  double time = 0.0;                              ///< seconds
  double length = 0.0;
  double min_clearance = 0.0;
  double tracking_max = 0.0, tracking_rms = 0.0;  ///< of where the vehicle believes to be, off the command, metres
  double pose_max = 0.0;                          ///< of where it believes to be, off the truth, metres
  double full_knowledge = 0.0;                    ///< full_knowledge_time(), where it was asked for
  std::uint32_t asked = 0, committed = 0, dropped = 0, failed = 0;
  std::array<double, 5> seconds_in{};  ///< of each tern::FlightMode
  double standing = 0.0;               ///< seconds in which the commands were slower than kStanding
  double view_wait = 0.0;              ///< seconds in which the field of view slowed the flight
  std::uint32_t work_max = 0, work_p99 = 0;
  std::uint64_t work_total = 0;
  std::uint64_t commands_hash = 0;
  std::uint64_t skipped = 0;  ///< ticks
  WatchTotals watched;
  std::vector<MissionPoint> mission;
  std::vector<FlightCommit> commits;
  std::vector<Appearance> appeared;  ///< with the time when each did
  FlightContact contact;
  ThingTotals things;
  FarTotals far;
  std::vector<TrackPoint> track;  ///< one a tick
  std::string samples;            ///< CSV, one row a tick

  /// In words; empty for nothing.
  std::string blocked() const;
  bool reached() const { return status == "reached"; }
  /// Something was in the way of the goal at the end.
  bool is_blocked() const { return !reached() && blocked_by != tern::BlockedBy::kNothing; }
};

/// What an onlooker sees in each tick, after the flight has done its part of it.
struct FlightMoment {
  std::int64_t t;  ///< nanoseconds
  const tern::FlightReport& report;
  const tern::Command& command;
  const Vehicle& vehicle;
  double yaw;        ///< of the camera, rad
  double clearance;  ///< of the vehicle's centre, metres
  const tern::RollingMap& map;
  const tern::Flight& flight;
  const tern::Planner& planner;
  const tern::FlightState& state;  ///< the flight's own, for displays
};
using FlightOnlooker = std::function<void(const FlightMoment&)>;

/// Flies it; `onlooker` may be empty, and changes nothing. `record` gets the flight's record (docs/record.md), unless
/// it is null. Throws std::runtime_error where the flight cannot begin.
FlightResult simulate_flight(const FlightWorld& world, const FlightOnlooker& onlooker = {},
                             std::string* record = nullptr);

/// The log, as JSON (docs/formats.md); with the commits and the true world where asked for.
std::string flight_json(const FlightWorld& world, const FlightResult& result, bool with_commits = false);

}  // namespace tern_host

#endif
