// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a flight node shows of a flight: markers, the map and diagnostics, beside the true world.
#ifndef TERN_TESTS_PORTS_ROS1_FLOWN_DISPLAYS_HPP
#define TERN_TESTS_PORTS_ROS1_FLOWN_DISPLAYS_HPP

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <map>
#include <string>

#include "host/flight/flight_world.hpp"

namespace tern_test {

class FlownDisplays {
 public:
  FlownDisplays(const tern_host::FlightWorld& world, ros::NodeHandle& node);
  bool connected() const { return diagnostics_.getNumPublishers() > 0; }
  /// The last message of the diagnostics.
  const std::string& told() const { return told_; }
  /// As the fields of a JSON object: how often each marker was there, how many voxels of obstacles came at most, how
  /// far the farthest of them was from a true obstacle, and the last diagnostics.
  std::string json() const;

 private:
  void on_markers(const visualization_msgs::MarkerArray& message);
  void on_obstacles(const sensor_msgs::PointCloud2& message);
  void on_diagnostics(const diagnostic_msgs::DiagnosticArray& message);

  const tern_host::FlightWorld& world_;
  std::map<std::string, int> shown_;
  std::size_t obstacles_ = 0;
  double obstacles_off_ = 0.0;
  std::string told_;
  std::map<std::string, std::string> values_;
  ros::Subscriber markers_, map_, diagnostics_;
};

}  // namespace tern_test

#endif
