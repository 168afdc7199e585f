// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A ROS 2 node: clouds and a pose in, for each goal a trajectory and a marker out.
#include <functional>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/point_cloud2.hpp>
#include <string>
#include <trajectory_msgs/msg/multi_dof_joint_trajectory.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include "tern_ros/planning.hpp"

namespace {

using geometry_msgs::msg::PoseStamped;
using sensor_msgs::msg::PointCloud2;
using trajectory_msgs::msg::MultiDOFJointTrajectory;
using visualization_msgs::msg::MarkerArray;

class Node : public rclcpp::Node {
 public:
  Node() : rclcpp::Node("tern") {
    tern_ros::Settings s;
    s.frame = declare_parameter("frame", s.frame);
    s.cell = declare_parameter("cell", s.cell);
    s.radius = declare_parameter("radius", s.radius);
    s.tracking_margin = declare_parameter("tracking_margin", s.tracking_margin);
    s.speed = declare_parameter("speed", s.speed);
    s.acceleration = declare_parameter("acceleration", s.acceleration);
    s.yaw_rate = declare_parameter("yaw_rate", s.yaw_rate);
    s.rate = declare_parameter("rate", s.rate);
    s.pose_timeout = declare_parameter("pose_timeout", s.pose_timeout);
    s.world.lower.z = declare_parameter("ground", s.world.lower.z);
    s.world.upper.z = declare_parameter("ceiling", s.world.upper.z);
    planning_ = std::make_unique<tern_ros::Planning>(s);
    trajectories_ = create_publisher<MultiDOFJointTrajectory>("trajectory", rclcpp::QoS(1).transient_local());
    markers_ = create_publisher<MarkerArray>("markers", rclcpp::QoS(1).transient_local());
    clouds_ = create_subscription<PointCloud2>("cloud", rclcpp::SensorDataQoS(),
                                               [this](const PointCloud2& cloud) { on_cloud(cloud); });
    // Estimators publish poses as sensor data, best effort: a reliable subscription would never be connected.
    poses_ = create_subscription<PoseStamped>("pose", rclcpp::SensorDataQoS(),
                                              [this](const PoseStamped& pose) { on_pose(pose); });
    goals_ =
        create_subscription<PoseStamped>("goal", rclcpp::QoS(1), [this](const PoseStamped& goal) { on_goal(goal); });
  }
  bool ready() const { return planning_->ready(); }

 private:
  void on_cloud(const PointCloud2& cloud) {
    std::string why;
    if (!planning_->add_cloud(cloud, &why)) RCLCPP_WARN(get_logger(), "cloud refused: %s", why.c_str());
  }
  void on_pose(const PoseStamped& pose) {
    const std::string answer = planning_->set_pose(pose, now().seconds());
    if (answer != last_pose_ && answer != "ok") RCLCPP_WARN(get_logger(), "pose refused: %s", answer.c_str());
    last_pose_ = answer;
  }
  void on_goal(const PoseStamped& goal) {
    MultiDOFJointTrajectory trajectory;
    MarkerArray markers;
    markers.markers.resize(1);
    const std::string answer = planning_->plan_to(goal, trajectory, markers.markers[0], now().seconds());
    if (answer != "ok") {
      RCLCPP_WARN(get_logger(), "no plan: %s", answer.c_str());
      return;
    }
    trajectory.header.frame_id = markers.markers[0].header.frame_id = planning_->settings().frame;
    trajectory.header.stamp = markers.markers[0].header.stamp = now();
    trajectories_->publish(trajectory);
    markers_->publish(markers);
    RCLCPP_INFO(get_logger(), "plan of %.2f s", tern::duration(planning_->plan()));
  }

  std::unique_ptr<tern_ros::Planning> planning_;
  std::string last_pose_ = "ok";  // the last answer, so that a fault is said once
  rclcpp::Publisher<MultiDOFJointTrajectory>::SharedPtr trajectories_;
  rclcpp::Publisher<MarkerArray>::SharedPtr markers_;
  rclcpp::Subscription<PointCloud2>::SharedPtr clouds_;
  rclcpp::Subscription<PoseStamped>::SharedPtr poses_, goals_;
};

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<Node>();
  if (!node->ready()) return 1;
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
