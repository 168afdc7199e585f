// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a node is told beside the parameters of port/onboard.
#ifndef TERN_ROS_OPTIONS_HPP
#define TERN_ROS_OPTIONS_HPP

#include <cctype>
#include <sstream>
#include <string>
#include <vector>

#include "tern_ros/classes.hpp"

namespace tern_ros {

struct Options {
  std::string frame = "map";             ///< of poses, goals and setpoints: z up
  std::string body_frame = "base_link";  ///< x ahead, y left, z up
  std::string cameras = "camera";        ///< names of depth cameras, separated by spaces
  std::string lidars;                    ///< and of lidars
  std::string output = "multidof";       ///< or mavros, or px4
  std::string record;                    ///< folder for the records of flights; empty: none
  double setpoint_rate = 50.0;           ///< Hz
  double display_rate = 5.0;             ///< Hz, of markers, map and diagnostics
  double via_tolerance = 0.5;            ///< m, of all points of a mission but the last
  DetectionOptions detections;           ///< of things that move
};

inline std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// What is wrong with them; empty if nothing is.
inline std::string options_fault(const Options& options) {
  const auto rate = [](const char* name, double value, double most) {
    std::ostringstream text;
    if (!(value >= 0.1 && value <= most)) {
      text << "parameter " << name << " = " << value << " Hz is refused: allowed are from 0.1 to " << most << " Hz";
    }
    return text.str();
  };
  if (options.frame.empty() || options.body_frame.empty()) return "parameters frame and body_frame must not be empty";
  for (const std::string& name : words_of(options.cameras + " " + options.lidars)) {
    for (const char c : name) {
      if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') continue;
      return "parameters cameras and lidars: the name \"" + name + "\" is refused: letters, digits and _ are allowed";
    }
  }
  const DetectionOptions& detections = options.detections;
  if (!(detections.least_score >= 0.0 && detections.least_score <= 1.0)) {
    return "parameter least_score is refused: it must be from 0 to 1";
  }
  if (!(detections.deviation >= 0.0 && detections.speed_deviation >= 0.0)) {
    return "parameters detection_deviation and detection_speed_deviation are refused: they must not be negative";
  }
  if (!(options.via_tolerance >= 0.0)) return "parameter via_tolerance is refused: it must not be negative";
  const std::string fault = rate("setpoint_rate", options.setpoint_rate, 500.0);
  return fault.empty() ? rate("display_rate", options.display_rate, 50.0) : fault;
}

}  // namespace tern_ros

#endif
