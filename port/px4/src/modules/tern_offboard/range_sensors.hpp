// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the autopilot's range sensors say, as scans of the map.
//
// distance_sensor: what the sensor measures is the nearest thing in its field of view, an ellipse of h_fov by v_fov. So
// that cone is free up to the measurement, less its error, and something may be anywhere in it at that distance. A
// voxel counts as seen free only with much of the cone around it, so a cone of less than about 70 degrees only adds
// obstacles.
//
// obstacle_distance: a ring around the vehicle, level as PX4 takes it. It says nothing of what is above and below, so
// it only adds obstacles.
#pragma once

#include <uORB/topics/distance_sensor.h>
#include <uORB/topics/obstacle_distance.h>

#include <tern/tern.hpp>

#include "topics.hpp"

namespace tern_offboard {

constexpr double kWideEnough = 0.3;  // rad, h_fov: a narrower sensor misses what the vehicle's side would touch
constexpr int kDistanceSensors = 4;
constexpr size_t kMostBeams = 1024;

/// Reads both topics and enters one measurement after the other. Sensors sit at the vehicle's centre: the radius must
/// hold how far they are from it. Those that look up or down are left out, because floors and ceilings are the map's.
class RangeSensors {
 public:
  /// Takes what is new. The older measurement of a sensor is forgotten.
  void look(hrt_abstime now);
  /// Whether a ring, or a sensor that looks ahead and is wide enough, sent something within the last 0.5 s.
  bool are_there(hrt_abstime now) const { return heard_ != 0 && now - heard_ < 500000; }
  /// Begins to enter the next measurement that waits, if the map has time for it. Position and attitude are those of
  /// now: measurements older than 0.2 s are left out.
  void enter(tern::RollingMap& map, const Seen& seen);

 private:
  bool is_usable(const distance_sensor_s& sensor) const;
  bool shows_the_way(const distance_sensor_s& sensor) const;
  bool scan(int sensor, const Seen& seen);
  void scan_cone(const distance_sensor_s& sensor, const Seen& seen);
  void scan_ring(const obstacle_distance_s& ring, const Seen& seen);
  void add(const tern::Vec3& ned, double range);

  uORB::Subscription distances_[kDistanceSensors] = {
      uORB::Subscription(ORB_ID(distance_sensor), 0), uORB::Subscription(ORB_ID(distance_sensor), 1),
      uORB::Subscription(ORB_ID(distance_sensor), 2), uORB::Subscription(ORB_ID(distance_sensor), 3)};
  uORB::Subscription rings_{ORB_ID(obstacle_distance)};
  distance_sensor_s distance_[kDistanceSensors] = {};
  obstacle_distance_s ring_ = {};
  bool waits_[kDistanceSensors + 1] = {};  // the last one is the ring's
  int next_ = 0;
  hrt_abstime heard_ = 0;

  tern::Vec3 directions_[kMostBeams];
  float ranges_[kMostBeams];
  size_t count_ = 0;
};

}  // namespace tern_offboard
