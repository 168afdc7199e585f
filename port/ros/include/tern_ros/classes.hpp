// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How detections are to be read: which classes their labels are, and what counts where they say nothing.
#ifndef TERN_ROS_CLASSES_HPP
#define TERN_ROS_CLASSES_HPP

#include <map>
#include <sstream>
#include <string>

#include "tern/track_class.hpp"

namespace tern_ros {

/// Labels that need no parameter: the classes' own names, and what detectors call them.
inline std::map<std::string, tern::TrackClass> known_labels() {
  using Class = tern::TrackClass;
  return {{"person", Class::kPerson},     {"pedestrian", Class::kPerson},  {"cyclist", Class::kCyclist},
          {"bicycle", Class::kCyclist},   {"animal", Class::kCyclist},     {"dog", Class::kCyclist},
          {"car", Class::kCar},           {"motorcycle", Class::kCar},     {"truck", Class::kTruck},
          {"bus", Class::kTruck},         {"trailer", Class::kTruck},      {"bird", Class::kBird},
          {"drone", Class::kDrone},       {"uav", Class::kDrone},          {"aircraft", Class::kAircraft},
          {"airplane", Class::kAircraft}, {"helicopter", Class::kAircraft}};
}

struct DetectionOptions {
  std::string kind;  ///< of the messages: vision, autoware, or none
  std::map<std::string, tern::TrackClass> labels = known_labels();
  tern::TrackClass other_class = tern::TrackClass::kPerson;  ///< of what has another label, or none
  bool tracker = false;                                      ///< detections have no identities or velocities: find them
  double least_score = 0.3;                                  ///< of detections that count
  double deviation = 0.3;                                    ///< m, of a position whose covariance is not given
  double speed_deviation = 0.5;                              ///< m/s, likewise
};

/// The class of a label. If it is not known, `unknown` becomes the label.
inline tern::TrackClass class_of(const DetectionOptions& options, const std::string& label, std::string& unknown) {
  const auto known = options.labels.find(label);
  if (known != options.labels.end()) return known->second;
  unknown = label.empty() ? "none" : label;
  return options.other_class;
}

/// Reads "LABEL=CLASS LABEL=CLASS" and the name of the class for all others. What is wrong; empty if nothing is.
inline std::string read_classes(const std::string& text, const std::string& other, DetectionOptions& options) {
  const std::map<std::string, tern::TrackClass> names = known_labels();
  const char* const kAllowed = "person, cyclist, car, truck, bird, drone and aircraft";
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::size_t sign = word.rfind('=');
    const auto name = sign == std::string::npos ? names.end() : names.find(word.substr(sign + 1));
    if (name == names.end() || sign == 0) {
      return "parameter detection_classes: \"" + word + "\" is refused: write LABEL=CLASS; classes are " + kAllowed;
    }
    options.labels[word.substr(0, sign)] = name->second;
  }
  const auto name = names.find(other);
  if (name == names.end()) return "parameter other_class = \"" + other + "\" is refused: allowed are " + kAllowed;
  options.other_class = name->second;
  return {};
}

}  // namespace tern_ros

#endif
