// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Stand-ins for the messages of detectors and trackers, written from their definitions: vision_msgs 4, and
// autoware_perception_msgs without accelerations and predicted paths, which port/ros does not read.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "messages.hpp"

namespace vision_msgs::msg {
struct ObjectHypothesis {
  std::string class_id;
  double score = 0.0;
};
struct ObjectHypothesisWithPose {
  ObjectHypothesis hypothesis;
  geometry_msgs::msg::PoseWithCovariance pose;
};
struct BoundingBox3D {
  geometry_msgs::msg::Pose center;
  geometry_msgs::msg::Vector3 size;
};
struct Detection3D {
  std_msgs::msg::Header header;
  std::vector<ObjectHypothesisWithPose> results;
  BoundingBox3D bbox;
  std::string id;
};
struct Detection3DArray {
  std_msgs::msg::Header header;
  std::vector<Detection3D> detections;
};
}  // namespace vision_msgs::msg

namespace autoware_perception_msgs::msg {
struct ObjectId {  // unique_identifier_msgs/UUID
  std::array<std::uint8_t, 16> uuid{};
};
struct ObjectClassification {
  static constexpr std::uint8_t CAR = 1, BUS = 3, MOTORCYCLE = 5, BICYCLE = 6, PEDESTRIAN = 7;
  std::uint8_t label = 0;
  float probability = 0.0f;
};
struct FootprintPoint {  // geometry_msgs/Point32
  float x = 0.0f, y = 0.0f, z = 0.0f;
};
struct Footprint {  // geometry_msgs/Polygon
  std::vector<FootprintPoint> points;
};
struct Shape {
  static constexpr std::uint8_t BOUNDING_BOX = 0, CYLINDER = 1, POLYGON = 2;
  std::uint8_t type = 0;
  Footprint footprint;
  geometry_msgs::msg::Vector3 dimensions;
};
struct PredictedObjectKinematics {
  geometry_msgs::msg::PoseWithCovariance initial_pose_with_covariance;
  geometry_msgs::msg::TwistWithCovariance initial_twist_with_covariance;
};
struct PredictedObject {
  ObjectId object_id;
  float existence_probability = 0.0f;
  std::vector<ObjectClassification> classification;
  PredictedObjectKinematics kinematics;
  Shape shape;
};
struct PredictedObjects {
  std_msgs::msg::Header header;
  std::vector<PredictedObject> objects;
};
}  // namespace autoware_perception_msgs::msg
