// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the ROS 2 node listens to for things that move. The packages of the messages may be missing.
#ifndef TERN_ROS_ROS2_DETECTIONS_HPP
#define TERN_ROS_ROS2_DETECTIONS_HPP

#include <cstdint>
#include <functional>
#include <stdexcept>
#if __has_include(<vision_msgs/msg/detection3_d_array.hpp>)
#include <vision_msgs/msg/detection3_d_array.hpp>
#define TERN_ROS_HAS_VISION
#endif
#if __has_include(<autoware_perception_msgs/msg/predicted_objects.hpp>)
#include <autoware_perception_msgs/msg/predicted_objects.hpp>
#define TERN_ROS_HAS_AUTOWARE
#endif

#include "senders.hpp"

namespace tern_ros {

/// Listens to the topic `detections`, if the parameter of that name says to what. Throws std::invalid_argument if it
/// cannot.
inline void listen_to_detections(const SenderParts& parts, const std::function<std::int64_t()>& now) {
  const std::string& kind = parts.options.detections.kind;
  if (kind.empty()) return;
  [[maybe_unused]] FlightTopics* const topics = &parts.topics;
#ifdef TERN_ROS_HAS_VISION
  if (kind == "vision") {
    return parts.on<vision_msgs::msg::Detection3DArray>(
        "detections", [topics, now](const auto& message) { topics->on_detections(message, now()); });
  }
#endif
#ifdef TERN_ROS_HAS_AUTOWARE
  if (kind == "autoware") {
    return parts.on<autoware_perception_msgs::msg::PredictedObjects>(
        "detections", [topics, now](const auto& message) { topics->on_objects(message, now()); });
  }
#endif
  throw std::invalid_argument("parameter detections = \"" + kind +
                              "\" is refused: this node can read vision and autoware if it was built with vision_msgs "
                              "and autoware_perception_msgs");
}

}  // namespace tern_ros

#endif
