// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// port/ros's reading of detections, in the shapes of ROS 1 and ROS 2.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "ros2/standins/perception.hpp"
#include "tern_ros/detections.hpp"

namespace {

using autoware_perception_msgs::msg::ObjectClassification;
using autoware_perception_msgs::msg::PredictedObject;
using autoware_perception_msgs::msg::Shape;
using tern_onboard::Sighting;
using tern_ros::DetectionFrame;
using tern_ros::DetectionOptions;
using vision_msgs::msg::Detection3D;

const double kHalf = std::sqrt(0.5);
constexpr double kClose = 1e-12;

/// vision_msgs/Detection3D of ROS 1: a class is a number, and the identity is the tracker's.
struct OldHypothesis {
  std::int64_t id = 0;
  double score = 0.0;
  geometry_msgs::msg::PoseWithCovariance pose;
};
struct OldDetection {
  std::vector<OldHypothesis> results;
  vision_msgs::msg::BoundingBox3D bbox;
  bool is_tracking = false;
  std::string tracking_id;
};
/// The same before trackers were thought of.
struct OldestDetection {
  std::vector<OldHypothesis> results;
  vision_msgs::msg::BoundingBox3D bbox;
};

/// A person 4 m ahead of a frame that stands at (10, 0, 1) and looks north.
Detection3D person() {
  Detection3D detection;
  detection.id = "7";
  detection.bbox.center.position.x = 4.0;
  detection.bbox.size.x = 0.6;
  detection.bbox.size.y = 0.8;
  detection.bbox.size.z = 1.8;
  detection.results.resize(2);
  detection.results[0].hypothesis = {"car", 0.4};
  detection.results[1].hypothesis = {"person", 0.5};
  detection.results[1].pose.covariance[0] = 0.04;
  detection.results[1].pose.covariance[7] = 0.01;
  detection.results[1].pose.covariance[14] = 0.0025;
  return detection;
}
DetectionFrame frame() {
  DetectionFrame at;
  at.pose = {{10.0, 0.0, 1.0}, {kHalf, 0.0, 0.0, kHalf}};
  at.stamp = 5;
  at.error = 0.05;
  at.turn_error = 0.02;
  return at;
}

class RosDetections : public testing::Test {
 protected:
  template <typename Detection>
  std::optional<Sighting> read(const Detection& detection) {
    label_ = why_ = "";
    return tern_ros::read_detection(detection, frame(), options_, label_, why_);
  }
  std::optional<Sighting> read_object(const PredictedObject& object) {
    label_ = why_ = "";
    return tern_ros::read_object(object, frame(), options_, label_, why_);
  }

  DetectionOptions options_;
  std::string label_, why_;
};

TEST_F(RosDetections, ABoxIsTurnedIntoTheWorldAndBounded) {
  const auto s = read(person());
  ASSERT_TRUE(s.has_value()) << why_;
  EXPECT_EQ(s->name, "detection 7");
  EXPECT_EQ(s->kind, tern::TrackClass::kPerson) << "the likelier one";
  EXPECT_EQ(s->stamp, 5);
  EXPECT_NEAR(s->position.x, 10.0, kClose);
  EXPECT_NEAR(s->position.y, 4.0, kClose);
  EXPECT_NEAR(s->position.z, 1.0, kClose);
  EXPECT_FALSE(s->has_velocity);
  EXPECT_NEAR(s->radius, 0.5, kClose);  // 0.3 and 0.4 m
  EXPECT_NEAR(s->half_height, 0.9, kClose);
  EXPECT_NEAR(s->deviation, 0.2, kClose);
  EXPECT_NEAR(s->error, 0.05 + 0.02 * 4.0, kClose) << "of the frame, and of its attitude over 4 m";
}

/// A box that lies: its length is in the air, and its height across.
TEST_F(RosDetections, ABoxThatIsNotUprightIsBoundedToo) {
  Detection3D detection = person();
  detection.bbox.center.orientation = {0.0, kHalf, 0.0, kHalf};  // x, y, z, w: x downwards
  const auto s = read(detection);
  ASSERT_TRUE(s.has_value());
  EXPECT_NEAR(s->half_height, 0.3, kClose);
  EXPECT_NEAR(s->radius, std::hypot(0.4, 0.9), kClose);
}

TEST_F(RosDetections, TheShapesOfRos1AreRead) {
  OldDetection old;
  old.bbox = person().bbox;
  old.tracking_id = "42";
  old.results.resize(1);
  old.results[0].id = 2;
  old.results[0].score = 0.9;
  EXPECT_EQ(tern_ros::read_classes("2=car 0=person", "bird", options_), "");
  auto s = read(old);
  ASSERT_TRUE(s.has_value()) << why_;
  EXPECT_EQ(s->name, "detection 42");
  EXPECT_EQ(s->kind, tern::TrackClass::kCar);
  EXPECT_EQ(label_, "");
  old.results[0].id = 5;
  s = read(old);
  EXPECT_EQ(s->kind, tern::TrackClass::kBird) << "other_class";
  EXPECT_EQ(label_, "5");
  OldestDetection oldest;
  oldest.bbox = old.bbox;
  ASSERT_TRUE(read(oldest).has_value());
  EXPECT_EQ(read(oldest)->name, "") << "a tracker's to give";
}

TEST_F(RosDetections, WhatIsNotKnownIsBounded) {
  Detection3D detection = person();
  for (double& c : detection.results[1].pose.covariance) c = 0.0;
  EXPECT_EQ(read(detection)->deviation, 0.3);
  detection.results[1].pose.covariance[0] = -1.0;
  EXPECT_EQ(read(detection)->deviation, 0.3);
  detection.results[1].pose.covariance[0] = std::nan("");
  EXPECT_TRUE(std::isnan(read(detection)->deviation)) << "refused later, and said";
  detection = person();
  detection.bbox.size.z = 0.0;
  detection.results[1].pose.pose.position.x = 3.0;
  auto s = read(detection);
  EXPECT_EQ(s->radius, 0.0) << "its class's";
  EXPECT_NEAR(s->position.y, 3.0, kClose) << "without a box, the hypothesis says where";
  detection.results.clear();
  s = read(detection);
  EXPECT_EQ(label_, "none");
  EXPECT_NEAR(s->position.y, 4.0, kClose);
}

TEST_F(RosDetections, NothingIsReadFromPoorOnes) {
  Detection3D detection = person();
  detection.results[1].hypothesis.score = 0.2;
  detection.results[0].hypothesis.score = 0.29;
  EXPECT_FALSE(read(detection).has_value());
  EXPECT_EQ(why_, "");
  detection = person();
  detection.results[1].hypothesis.score = std::nan("");
  detection.results[0].hypothesis.score = 0.1;
  EXPECT_FALSE(read(detection).has_value());
  detection = person();
  detection.bbox.center.orientation.w = 0.5;
  EXPECT_FALSE(read(detection).has_value());
  EXPECT_NE(why_.find("orientation"), std::string::npos);
}

/// A car 8 m ahead that drives to the left, which is west of a frame that looks north.
PredictedObject car() {
  PredictedObject object;
  object.object_id.uuid = {0xab, 0xcd};
  object.existence_probability = 0.75f;
  object.classification = {{ObjectClassification::BUS, 0.25f}, {ObjectClassification::CAR, 0.75f}};
  auto& pose = object.kinematics.initial_pose_with_covariance;
  pose.pose.position.x = 8.0;
  pose.pose.orientation = {0.0, 0.0, kHalf, kHalf};
  pose.covariance[0] = 0.25;
  pose.covariance[7] = 0.01;
  object.kinematics.initial_twist_with_covariance.twist.linear.x = 10.0;
  object.kinematics.initial_twist_with_covariance.covariance[0] = 1.0;
  object.shape.dimensions.x = 4.0;
  object.shape.dimensions.y = 3.0;
  object.shape.dimensions.z = 1.5;
  return object;
}

TEST_F(RosDetections, AnObjectsTwistIsInItsOwnAxes) {
  const auto s = read_object(car());
  ASSERT_TRUE(s.has_value()) << why_;
  EXPECT_EQ(s->name, "object abcd0000000000000000000000000000");
  EXPECT_EQ(s->kind, tern::TrackClass::kCar);
  EXPECT_NEAR(s->position.y, 8.0, kClose);
  ASSERT_TRUE(s->has_velocity);
  EXPECT_NEAR(s->velocity.x, -10.0, 1e-9);
  EXPECT_NEAR(s->velocity.y, 0.0, 1e-9);
  EXPECT_NEAR(s->deviation, 0.5, kClose);
  EXPECT_NEAR(s->speed_deviation, 1.0, kClose);
  EXPECT_NEAR(s->speed_error, 0.2, 1e-9) << "of the attitude, at 10 m/s";
  EXPECT_NEAR(s->radius, 2.5, kClose);
  EXPECT_NEAR(s->half_height, 0.75, kClose);
}

TEST_F(RosDetections, ObjectsHaveThreeShapes) {
  PredictedObject object = car();
  object.shape.type = Shape::CYLINDER;
  EXPECT_NEAR(read_object(object)->radius, 2.0, kClose) << "x is the diameter";
  object.shape.type = Shape::POLYGON;
  object.shape.footprint.points = {{1.0f, 0.0f, 0.0f}, {-3.0f, 4.0f, 0.0f}};
  EXPECT_NEAR(read_object(object)->radius, 5.0, kClose);
  object.shape.footprint.points.clear();
  EXPECT_EQ(read_object(object)->radius, 0.0);
}

TEST_F(RosDetections, ObjectsThatHardlyExistOrHaveNoClass) {
  PredictedObject object = car();
  object.existence_probability = 0.25f;
  EXPECT_FALSE(read_object(object).has_value());
  object = car();
  for (const auto& [number, kind] : {std::pair{ObjectClassification::BUS, tern::TrackClass::kTruck},
                                     {ObjectClassification::MOTORCYCLE, tern::TrackClass::kCar},
                                     {ObjectClassification::BICYCLE, tern::TrackClass::kCyclist},
                                     {ObjectClassification::PEDESTRIAN, tern::TrackClass::kPerson}}) {
    object.classification = {{number, 1.0f}};
    EXPECT_EQ(read_object(object)->kind, kind);
    EXPECT_EQ(label_, "");
  }
  for (const std::uint8_t other : {0, 9, 200}) {
    object.classification = {{other, 1.0f}};
    EXPECT_EQ(read_object(object)->kind, tern::TrackClass::kPerson);
    EXPECT_EQ(label_, "none");
  }
}

TEST(RosClasses, AreRefusedWithAReason) {
  DetectionOptions options;
  EXPECT_EQ(tern_ros::read_classes("", "person", options), "");
  EXPECT_NE(tern_ros::read_classes("2=boat", "person", options).find("\"2=boat\" is refused"), std::string::npos);
  EXPECT_NE(tern_ros::read_classes("car", "person", options).find("\"car\" is refused"), std::string::npos);
  EXPECT_NE(tern_ros::read_classes("=car", "person", options).find("\"=car\" is refused"), std::string::npos);
  EXPECT_NE(tern_ros::read_classes("", "boat", options).find("other_class = \"boat\" is refused"), std::string::npos);
  EXPECT_EQ(tern_ros::read_classes("a=b=car", "person", options), "");
  EXPECT_EQ(options.labels.at("a=b"), tern::TrackClass::kCar);
}

}  // namespace
