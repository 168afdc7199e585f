// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A vehicle's own lidar, for worlds that are not known beforehand: it fills the vehicle's map with what stands still.
#ifndef TERN_HOST_SWARM_SWARM_SENSOR_HPP
#define TERN_HOST_SWARM_SWARM_SENSOR_HPP

#include <cstdint>

#include "host/flight/lidar.hpp"
#include "host/swarm/swarm_world.hpp"
#include "tern/flight.hpp"
#include "tern/map.hpp"

namespace tern_host {

/// A level lidar that sees all around, 45 degrees up and down, ten times a second. It does not see other vehicles.
class SwarmSensor {
 public:
  /// `range`: m. `margin`: the tracking margin of the map, m.
  SwarmSensor(const SwarmWorld& world, const SwarmTask& task, double range, double margin);

  /// What a map and a flight must know of the sensor.
  void describe(tern::MapSpec& spec) const;
  void describe(tern::FlightSpec& spec) const;
  /// What an operator knows before the flight: what is around the start is free.
  void assume_start(tern::RollingMap& map) const;
  /// If it is time and the map is ready, begins to enter what is seen from a place.
  void look(const tern::Vec3& place, std::int64_t time, tern::RollingMap& map);

 private:
  FlightWorld truth_;
  Noise noise_{1};  ///< not used: it measures without error
  LidarScan scan_;  ///< in work in the map, or the last one that was
  std::int64_t next_ = INT64_MIN;
};

}  // namespace tern_host

#endif
