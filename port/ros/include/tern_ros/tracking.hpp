// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tern's tracker for a node's detections, or for what its sensors see move, if Tern was installed with it.
#ifndef TERN_ROS_TRACKING_HPP
#define TERN_ROS_TRACKING_HPP

#include <cstdint>
#include <memory>
#include <stdexcept>
#if __has_include(<tern_tracker/tracker.hpp>)
#include "tern_tracker/cluster_detector.hpp"
#include "tern_tracker/tracker.hpp"
#define TERN_ROS_HAS_TRACKER
#endif

#include "tern_ros/flight_topics.hpp"
#include "tern_ros/options.hpp"

namespace tern_ros {

/// Does what the parameter `tracker` asks for. Throws std::invalid_argument if it cannot.
inline void use_tracker([[maybe_unused]] FlightTopics& topics, const Options& options) {
  if (!options.detections.tracker) return;
#ifdef TERN_ROS_HAS_TRACKER
  topics.set_tracker([tracker = std::make_shared<tern_tracker::Tracker>()](std::int64_t stamp, const auto& detections) {
    return tracker->scan(stamp, detections);
  });
#else
  throw std::invalid_argument("parameter tracker is refused: build Tern with TERN_BUILD_TRACKER, and this node again");
#endif
}

/// What Onboard needs for the parameter `clusters`. Throws std::invalid_argument together with the parameter
/// `detections`.
inline std::unique_ptr<tern_onboard::Detector> detector_of(const tern_onboard::Settings& settings,
                                                           const Options& options) {
  if (settings.things.clusters == "none") return nullptr;
  if (!options.detections.kind.empty()) {
    throw std::invalid_argument(
        "parameter clusters is refused together with detections: whoever both see would be two things that move. Leave "
        "one of them out");
  }
#ifdef TERN_ROS_HAS_TRACKER
  return tern_tracker::detector_of(settings);
#else
  return nullptr;  // Onboard says what is missing
#endif
}

}  // namespace tern_ros

#endif
