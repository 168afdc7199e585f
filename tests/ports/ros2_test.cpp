// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// port/ros's node for ROS 2, over stand-ins for rclcpp and the messages. ROS 2 itself is not in Debian.
#define main tern_node_main
#include "../../port/ros/ros2/src/tern_node.cpp"
#undef main

#include <gtest/gtest.h>

#include "ros_clouds.hpp"

namespace {

PoseStamped pose_at(double x, double y, double z) {
  PoseStamped pose;
  pose.header.frame_id = "map";
  pose.pose.position = {x, y, z};
  return pose;
}

class Ros2 : public testing::Test {
 protected:
  void SetUp() override { rclcpp::bus() = rclcpp::Bus{}; }
  static int run() { return tern_node_main(0, nullptr); }
};

TEST_F(Ros2, PlansPastACloud) {
  rclcpp::bus().entered = {
      {"cloud", tern_test::cloud_of_wall<PointCloud2>()}, {"pose", pose_at(-3, 0, 1.5)}, {"goal", pose_at(4, 1, 1.5)}};
  ASSERT_EQ(run(), 0);
  ASSERT_EQ(rclcpp::bus().published.size(), 2u);
  const auto trajectory = std::any_cast<MultiDOFJointTrajectory>(rclcpp::bus().published[0].second);
  const char* fault = tern_test::fault_of(
      trajectory, [](const auto& point) { return point.time_from_start.sec + 1e-9 * point.time_from_start.nanosec; });
  EXPECT_EQ(fault, nullptr) << fault;
  EXPECT_EQ(trajectory.header.stamp.sec, 42);
  const auto markers = std::any_cast<MarkerArray>(rclcpp::bus().published[1].second);
  ASSERT_EQ(markers.markers.size(), 1u);
  EXPECT_EQ(markers.markers[0].points.size(), 201u);
  EXPECT_EQ(markers.markers[0].header.frame_id, "map");
}

TEST_F(Ros2, TakesParameters) {
  rclcpp::bus().parameters = {{"speed", 0.5}, {"rate", 10.0}};
  rclcpp::bus().entered = {{"pose", pose_at(-3, 0, 1.5)}, {"goal", pose_at(-1, 0, 1.5)}};
  ASSERT_EQ(run(), 0);
  ASSERT_EQ(rclcpp::bus().published.size(), 2u);
  const auto trajectory = std::any_cast<MultiDOFJointTrajectory>(rclcpp::bus().published[0].second);
  EXPECT_EQ(trajectory.points[1].time_from_start.nanosec, 100000000u);
  for (const auto& point : trajectory.points) EXPECT_LE(point.velocities[0].linear.x, 0.5 + 1e-6);
}

TEST_F(Ros2, PublishesNothingWithoutAPlan) {
  auto elsewhere = tern_test::cloud_of_wall<PointCloud2>();
  elsewhere.header.frame_id = "camera";
  auto short_of_data = tern_test::cloud_of_wall<PointCloud2>();
  short_of_data.data.pop_back();
  auto goal_elsewhere = pose_at(4, 1, 1.5);
  goal_elsewhere.header.frame_id = "odom";
  rclcpp::bus().entered = {{"goal", pose_at(4, 1, 1.5)},  // no pose yet
                           {"cloud", elsewhere},         {"cloud", short_of_data},     {"pose", pose_at(-3, 0, 1.5)},
                           {"goal", goal_elsewhere},     {"goal", pose_at(99, 0, 1.5)}};
  ASSERT_EQ(run(), 0);
  EXPECT_TRUE(rclcpp::bus().published.empty());
  // Neither of the clouds is in the map: the way is straight.
  rclcpp::bus().entered.emplace_back("goal", pose_at(4, 0, 1.5));
  ASSERT_EQ(run(), 0);
  ASSERT_EQ(rclcpp::bus().published.size(), 2u);
  const auto trajectory = std::any_cast<MultiDOFJointTrajectory>(rclcpp::bus().published[0].second);
  for (const auto& point : trajectory.points) EXPECT_NEAR(point.transforms[0].translation.y, 0.0, 1e-6);
}

TEST_F(Ros2, RefusesSettingsThatMakeNoGrid) {
  rclcpp::bus().parameters = {{"cell", -1.0}};
  EXPECT_EQ(run(), 1);
}

}  // namespace
