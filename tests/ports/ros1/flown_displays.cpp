// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros1/flown_displays.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "tern_ros/inputs.hpp"

namespace tern_test {

FlownDisplays::FlownDisplays(const tern_host::FlightWorld& world, ros::NodeHandle& node)
    : world_(world),
      markers_(node.subscribe("tern/markers", 4, &FlownDisplays::on_markers, this)),
      map_(node.subscribe("tern/obstacles", 4, &FlownDisplays::on_obstacles, this)),
      diagnostics_(node.subscribe("diagnostics", 4, &FlownDisplays::on_diagnostics, this)) {}

void FlownDisplays::on_markers(const visualization_msgs::MarkerArray& message) {
  for (const auto& marker : message.markers) {
    const bool is_there = marker.action == visualization_msgs::Marker::ADD && !marker.points.empty();
    const bool is_whole = std::all_of(marker.points.begin(), marker.points.end(),
                                      [](const auto& p) { return tern_onboard::is_finite(tern_ros::vector_of(p)); });
    shown_[is_whole ? marker.ns : "not_finite"] += is_there ? 1 : 0;
  }
}

void FlownDisplays::on_obstacles(const sensor_msgs::PointCloud2& message) {
  std::vector<tern::Vec3> points;
  tern_ros::read_points(message, {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}}, points);
  obstacles_ = std::max(obstacles_, points.size());
  for (const tern::Vec3& point : points) {
    obstacles_off_ = std::max(obstacles_off_, tern_host::clearance(world_, point));
  }
}

void FlownDisplays::on_diagnostics(const diagnostic_msgs::DiagnosticArray& message) {
  told_ = message.status.at(0).message;
  for (const auto& value : message.status[0].values) values_[value.key] = value.value;
}

std::string FlownDisplays::json() const {
  std::ostringstream text;
  text << "\"markers\": {";
  const char* comma = "";
  for (const auto& [name, count] : shown_) {
    text << comma << "\"" << name << "\": " << count;
    comma = ", ";
  }
  text << "}, \"obstacles\": " << obstacles_ << ", \"obstacles_off\": " << obstacles_off_ << ", \"diagnostics\": {";
  comma = "";
  for (const auto& [key, value] : values_) {
    text << comma << "\"" << key << "\": \"" << value << "\"";
    comma = ", ";
  }
  text << "}";
  return text.str();
}

}  // namespace tern_test
