// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Stand-ins for the messages of vision_msgs, which is not in Debian: the fields of its first version, with the sum that
// stands for any.
#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/PoseWithCovariance.h>
#include <geometry_msgs/Vector3.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Header.h>

#include <boost/shared_ptr.hpp>
#include <cstdint>
#include <vector>

#include "standin.hpp"

namespace vision_msgs {
struct ObjectHypothesisWithPose {
  static constexpr const char* kType = "vision_msgs/ObjectHypothesisWithPose";
  static constexpr const char* kSum = "*";
  std::int64_t id = 0;
  double score = 0.0;
  geometry_msgs::PoseWithCovariance pose;
  template <typename Stream, typename Self>
  static void all(Stream& s, Self& m) {
    s.next(m.id), s.next(m.score), s.next(m.pose);
  }
};
struct BoundingBox3D {
  static constexpr const char* kType = "vision_msgs/BoundingBox3D";
  static constexpr const char* kSum = "*";
  geometry_msgs::Pose center;
  geometry_msgs::Vector3 size;
  template <typename Stream, typename Self>
  static void all(Stream& s, Self& m) {
    s.next(m.center), s.next(m.size);
  }
};
struct Detection3D {
  static constexpr const char* kType = "vision_msgs/Detection3D";
  static constexpr const char* kSum = "*";
  std_msgs::Header header;
  std::vector<ObjectHypothesisWithPose> results;
  BoundingBox3D bbox;
  sensor_msgs::PointCloud2 source_cloud;
  template <typename Stream, typename Self>
  static void all(Stream& s, Self& m) {
    s.next(m.header), s.next(m.results), s.next(m.bbox), s.next(m.source_cloud);
  }
};
struct Detection3DArray {
  using ConstPtr = boost::shared_ptr<const Detection3DArray>;
  static constexpr const char* kType = "vision_msgs/Detection3DArray";
  static constexpr const char* kSum = "*";
  std_msgs::Header header;
  std::vector<Detection3D> detections;
  template <typename Stream, typename Self>
  static void all(Stream& s, Self& m) {
    s.next(m.header), s.next(m.detections);
  }
};
}  // namespace vision_msgs

TERN_ROS1_STANDIN(vision_msgs::ObjectHypothesisWithPose)
TERN_ROS1_STANDIN(vision_msgs::BoundingBox3D)
TERN_ROS1_STANDIN(vision_msgs::Detection3D)
TERN_ROS1_STANDIN(vision_msgs::Detection3DArray)
