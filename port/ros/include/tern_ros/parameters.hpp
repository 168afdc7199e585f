// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads a node's parameters, for ROS 1 and ROS 2. `get(name, otherwise)` is the node's way to ask for one of the type
// of `otherwise`. A value that is refused is thrown as std::invalid_argument, which says what is wrong with it.
#ifndef TERN_ROS_PARAMETERS_HPP
#define TERN_ROS_PARAMETERS_HPP

#include <stdexcept>
#include <string>

#include "tern_onboard/parameters.hpp"
#include "tern_ros/options.hpp"

namespace tern_ros {

/// Throws what is wrong; nothing is if `fault` is empty.
inline void require(const std::string& fault) {
  if (!fault.empty()) throw std::invalid_argument(fault);
}

template <typename Get>
Options read_options(const Get& get) {
  Options o;
  o.frame = get("frame", o.frame);
  o.body_frame = get("body_frame", o.body_frame);
  o.cameras = get("cameras", o.cameras);
  o.lidars = get("lidars", o.lidars);
  o.output = get("output", o.output);
  o.record = get("record", o.record);
  o.setpoint_rate = get("setpoint_rate", o.setpoint_rate);
  o.display_rate = get("display_rate", o.display_rate);
  o.via_tolerance = get("via_tolerance", o.via_tolerance);
  DetectionOptions& detections = o.detections;
  detections.kind = get("detections", detections.kind);
  detections.tracker = get("tracker", detections.tracker);
  detections.least_score = get("least_score", detections.least_score);
  detections.deviation = get("detection_deviation", detections.deviation);
  detections.speed_deviation = get("detection_speed_deviation", detections.speed_deviation);
  require(read_classes(get("detection_classes", std::string()), get("other_class", std::string("person")), detections));
  require(options_fault(o));
  return o;
}

template <typename Get>
tern_onboard::Settings read_settings(const Get& get) {
  tern_onboard::Settings settings;
  for (const auto& row : tern_onboard::parameters()) {
    require(tern_onboard::set_parameter(settings, row.name, get(row.name, row.get(settings))));
  }
  for (const auto& row : tern_onboard::word_parameters()) {
    require(tern_onboard::set_word(settings, row.name, get(row.name, row.of(settings))));
  }
  return settings;
}

/// Of one sensor, whose parameters' names begin with `prefix`.
template <typename Get>
tern_onboard::SensorSettings read_sensor_settings(const std::string& prefix, const Get& get) {
  tern_onboard::SensorSettings settings;
  for (const auto& row : tern_onboard::sensor_parameters()) {
    require(tern_onboard::set_parameter(settings, row.name, get(prefix + row.name, row.get(settings)), prefix));
  }
  return settings;
}

}  // namespace tern_ros

#endif
