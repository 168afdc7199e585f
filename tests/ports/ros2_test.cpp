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

TEST_F(Ros2, TakesPosesFromPublishersThatAreNotReliable) {
  ASSERT_EQ(run(), 0);
  EXPECT_FALSE(rclcpp::bus().reliable.at("pose"));
  EXPECT_FALSE(rclcpp::bus().reliable.at("cloud"));
}

TEST_F(Ros2, PlansFromNoPoseThatIsOld) {
  rclcpp::bus().entered = {{"pose", pose_at(-3, 0, 1.5)}, {"clock", 43.1}, {"goal", pose_at(4, 1, 1.5)}};
  ASSERT_EQ(run(), 0);
  EXPECT_TRUE(rclcpp::bus().published.empty());
  rclcpp::bus().entered = {{"pose", pose_at(-3, 0, 1.5)}, {"clock", 44.0}, {"goal", pose_at(4, 1, 1.5)}};
  ASSERT_EQ(run(), 0);
  EXPECT_EQ(rclcpp::bus().published.size(), 2u);
}

/// The answer of Planning to a goal after a pose.
std::string answer(const PoseStamped& pose, const PoseStamped& goal) {
  tern_ros::Planning planning{tern_ros::Settings()};
  MultiDOFJointTrajectory trajectory;
  visualization_msgs::msg::Marker marker;
  planning.set_pose(pose_at(-3, 0, 1.5));  // a good one before it
  planning.set_pose(pose);
  return planning.plan_to(goal, trajectory, marker);
}

PoseStamped in_frame(PoseStamped pose, const char* frame) {
  pose.header.frame_id = frame;
  return pose;
}

TEST_F(Ros2, ChecksFramesOfPosesAndGoals) {
  const PoseStamped here = pose_at(-3, 0, 1.5), there = pose_at(4, 1, 1.5);
  EXPECT_EQ(answer(here, there), "ok");
  for (const char* frame : {"base_link", "", "/map", "Map"}) {
    const std::string fault = "it is in frame \"" + std::string(frame) + "\", not \"map\"; transform it with tf2 first";
    EXPECT_EQ(answer(in_frame(here, frame), there), "there is no pose to begin at: " + fault);
    EXPECT_EQ(answer(here, in_frame(there, frame)), "the goal is refused: " + fault);
  }
  EXPECT_EQ(answer(pose_at(NAN, 0, 1.5), there), "there is no pose to begin at: it is not finite");
  EXPECT_EQ(answer(here, pose_at(4, NAN, 1.5)).substr(0, 16), "non_finite_input");
}

TEST_F(Ros2, KeepsTheBodyAboveTheGround) {
  const PoseStamped here = pose_at(-3, 0, 1.5);
  EXPECT_EQ(answer(here, pose_at(4, 1, 0.0)),
            "the goal is at a height of 0.00 m, and the body stays above the ground from 0.40 m on");
  EXPECT_EQ(answer(here, pose_at(4, 1, 0.4)), "ok");
  EXPECT_EQ(answer(pose_at(-3, 0, 0.1), pose_at(4, 1, 1.5)),
            "take off first: the vehicle is at a height of 0.10 m, and the body stays above the ground from 0.40 m on");
  // The ground of a valley: the plan keeps above it.
  tern_ros::Settings settings;
  settings.world.lower.z = -1.0;
  tern_ros::Planning lower(settings);
  MultiDOFJointTrajectory trajectory;
  visualization_msgs::msg::Marker marker;
  lower.set_pose(pose_at(-3, 0, -0.6));
  ASSERT_EQ(lower.plan_to(pose_at(4, 1, -0.55), trajectory, marker), "ok");
  for (const auto& point : trajectory.points) EXPECT_GE(point.transforms[0].translation.z, -0.6 - 1e-8);
}

TEST_F(Ros2, SaysWhyACloudIsRefused) {
  tern_ros::Planning planning{tern_ros::Settings()};
  std::string why;
  auto cloud = tern_test::cloud_of_wall<PointCloud2>();
  EXPECT_TRUE(planning.add_cloud(cloud, &why));
  EXPECT_EQ(why, "");
  cloud.header.frame_id = "camera";
  EXPECT_FALSE(planning.add_cloud(cloud, &why));
  EXPECT_EQ(why, "it is in frame \"camera\", not \"map\"; transform it with tf2 first");
  cloud.header.frame_id = "map";
  cloud.fields[0].datatype = 8;
  EXPECT_FALSE(planning.add_cloud(cloud, &why));
  EXPECT_NE(why.find("FLOAT32"), std::string::npos);
}

TEST_F(Ros2, NamesTheVehiclesOwnPoints) {
  tern_ros::Planning planning{tern_ros::Settings()};
  auto cloud = tern_test::cloud_of_wall<PointCloud2>();
  const float legs[3] = {-3.0f, 0.0f, 1.5f};
  std::memcpy(cloud.data.data(), legs, sizeof legs);
  ASSERT_TRUE(planning.add_cloud(cloud));
  planning.set_pose(pose_at(-3, 0, 1.5));
  MultiDOFJointTrajectory trajectory;
  visualization_msgs::msg::Marker marker;
  const std::string text = planning.plan_to(pose_at(4, 1, 1.5), trajectory, marker);
  EXPECT_EQ(text.substr(0, 15), "start_occupied:");
  EXPECT_NE(text.find("within 0.40 m of the vehicle. If they are its own body, filter them out."), std::string::npos)
      << text;
}

TEST_F(Ros2, RefusesSettingsThatMakeNoGrid) {
  rclcpp::bus().parameters = {{"cell", -1.0}};
  EXPECT_EQ(run(), 1);
}

}  // namespace
