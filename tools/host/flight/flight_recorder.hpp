// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_FLIGHT_RECORDER_HPP
#define TERN_HOST_FLIGHT_FLIGHT_RECORDER_HPP

#include <cstdint>
#include <vector>

#include "host/flight/simulated_flight.hpp"
#include "host/vehicle/vehicle.hpp"
#include "tern/flight.hpp"

namespace tern_host {

/// The vehicle that the settings name.
VehicleSettings vehicle_settings_of(const FlightSettings& settings);

/// Writes down a flight, tick by tick.
class FlightRecorder {
 public:
  explicit FlightRecorder(const FlightWorld& world) : world_(world) {}

  /// At every tick. `skipped`: it was not done, and the report is that of the last one that was.
  void note(std::int64_t t, const tern::Command& command, const Vehicle& vehicle, double yaw,
            const tern::FlightReport& report, bool skipped = false);
  /// Between two ticks.
  void note_clearance(const Vehicle& vehicle);
  /// The body touched a thing that moves: an event of the next row that has no other.
  void note_touch() { touched_ = true; }
  /// The vehicle's distance from everything after the last note.
  double clearance_now() const { return clearance_; }
  /// The largest errors so far.
  double tracking_max() const { return result_.tracking_max; }
  double pose_max() const { return result_.pose_max; }
  /// The record, complete but for what only the simulation knows.
  FlightResult finish();

 private:
  void hash(const tern::Sample& sample);
  void add_row(double t, const tern::Command& command, const Vehicle& vehicle, double yaw,
               const tern::FlightReport& report, const char* event);

  const FlightWorld& world_;
  FlightResult result_;
  tern::FlightReport last_{};
  std::uint64_t hash_ = 0xCBF29CE484222325u;
  std::vector<std::uint32_t> work_;
  double squares_ = 0.0;  ///< of tracking errors, summed
  double clearance_ = 0.0;
  bool touched_ = false;
};

}  // namespace tern_host

#endif
