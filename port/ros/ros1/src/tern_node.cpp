// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A ROS 1 node: clouds and a pose in, for each goal a trajectory and a marker out.
#include <geometry_msgs/PoseStamped.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <trajectory_msgs/MultiDOFJointTrajectory.h>
#include <visualization_msgs/MarkerArray.h>

#include "tern_ros/planning.hpp"

namespace {

tern_ros::Settings settings_of(const ros::NodeHandle& own) {
  tern_ros::Settings s;
  s.frame = own.param<std::string>("frame", s.frame);
  s.cell = own.param("cell", s.cell);
  s.radius = own.param("radius", s.radius);
  s.tracking_margin = own.param("tracking_margin", s.tracking_margin);
  s.speed = own.param("speed", s.speed);
  s.acceleration = own.param("acceleration", s.acceleration);
  s.yaw_rate = own.param("yaw_rate", s.yaw_rate);
  s.rate = own.param("rate", s.rate);
  s.pose_timeout = own.param("pose_timeout", s.pose_timeout);
  s.world.lower.z = own.param("ground", s.world.lower.z);
  s.world.upper.z = own.param("ceiling", s.world.upper.z);
  return s;
}

class Node {
 public:
  Node() : planning_(settings_of(ros::NodeHandle("~"))) {
    trajectories_ = node_.advertise<trajectory_msgs::MultiDOFJointTrajectory>("trajectory", 1, true);
    markers_ = node_.advertise<visualization_msgs::MarkerArray>("markers", 1, true);
    clouds_ = node_.subscribe("cloud", 4, &Node::on_cloud, this);
    poses_ = node_.subscribe("pose", 1, &Node::on_pose, this);
    goals_ = node_.subscribe("goal", 1, &Node::on_goal, this);
  }
  bool ready() const { return planning_.ready(); }

 private:
  void on_cloud(const sensor_msgs::PointCloud2& cloud) {
    std::string why;
    if (!planning_.add_cloud(cloud, &why)) ROS_WARN("cloud refused: %s", why.c_str());
  }
  void on_pose(const geometry_msgs::PoseStamped& pose) {
    const std::string answer = planning_.set_pose(pose, ros::Time::now().toSec());
    if (answer != last_pose_ && answer != "ok") ROS_WARN("pose refused: %s", answer.c_str());
    last_pose_ = answer;
  }
  void on_goal(const geometry_msgs::PoseStamped& goal) {
    trajectory_msgs::MultiDOFJointTrajectory trajectory;
    visualization_msgs::MarkerArray markers;
    markers.markers.resize(1);
    const std::string answer = planning_.plan_to(goal, trajectory, markers.markers[0], ros::Time::now().toSec());
    if (answer != "ok") {
      ROS_WARN("no plan: %s", answer.c_str());
      return;
    }
    trajectory.header.frame_id = markers.markers[0].header.frame_id = planning_.settings().frame;
    trajectory.header.stamp = markers.markers[0].header.stamp = ros::Time::now();
    trajectories_.publish(trajectory);
    markers_.publish(markers);
    ROS_INFO("plan of %.2f s", tern::duration(planning_.plan()));
  }

  ros::NodeHandle node_;
  tern_ros::Planning planning_;
  std::string last_pose_ = "ok";  // the last answer, so that a fault is said once
  ros::Publisher trajectories_, markers_;
  ros::Subscriber clouds_, poses_, goals_;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "tern");
  Node node;
  if (!node.ready()) return 1;
  ros::spin();
  return 0;
}
