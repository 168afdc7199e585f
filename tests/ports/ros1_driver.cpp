// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// ros1_driver BAG: records a cloud, a pose and a goal to a bag, plays the bag to port/ros's node, and checks the
// trajectory and the marker that come back.
#include <geometry_msgs/PoseStamped.h>
#include <ros/ros.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/PointCloud2.h>
#include <trajectory_msgs/MultiDOFJointTrajectory.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstdio>
#include <map>
#include <string>

#include "ros_clouds.hpp"

namespace {

geometry_msgs::PoseStamped pose_at(double x, double y, double z) {
  geometry_msgs::PoseStamped pose;
  pose.header.frame_id = "map";
  pose.pose.position.x = x;
  pose.pose.position.y = y;
  pose.pose.position.z = z;
  return pose;
}

void record(const std::string& file) {
  rosbag::Bag bag(file, rosbag::bagmode::Write);
  bag.write("/cloud", ros::Time(1.0), tern_test::cloud_of_wall<sensor_msgs::PointCloud2>());
  bag.write("/pose", ros::Time(2.0), pose_at(-3, 0, 1.5));
  bag.write("/goal", ros::Time(3.0), pose_at(4, 1, 1.5));
}

/// Publishes every message of the bag once the node listens. The topics keep no order between them, so the goal waits
/// until the rest was sent and is repeated until there is an answer.
class Player {
 public:
  Player() {
    publishers_["/cloud"] = node_.advertise<sensor_msgs::PointCloud2>("/cloud", 4);
    publishers_["/pose"] = node_.advertise<geometry_msgs::PoseStamped>("/pose", 4);
    publishers_["/goal"] = node_.advertise<geometry_msgs::PoseStamped>("/goal", 4);
    trajectories_ = node_.subscribe("/trajectory", 4, &Player::on_trajectory, this);
    markers_ = node_.subscribe("/markers", 4, &Player::on_markers, this);
  }
  /// False if nobody answers within 20 s.
  bool play(const std::string& file) {
    for (auto& [topic, publisher] : publishers_) {
      if (!wait([&publisher = publisher] { return publisher.getNumSubscribers() > 0; })) return false;
    }
    rosbag::Bag bag(file);
    for (const rosbag::MessageInstance& message : rosbag::View(bag)) {
      if (const auto cloud = message.instantiate<sensor_msgs::PointCloud2>()) publishers_["/cloud"].publish(*cloud);
      if (const auto pose = message.instantiate<geometry_msgs::PoseStamped>()) {
        publishers_[message.getTopic()].publish(*pose);
      }
      wait([] { return false; }, 0.5);
    }
    return wait([this] { return trajectory_.points.size() > 0 && marker_points_ > 0; });
  }
  const trajectory_msgs::MultiDOFJointTrajectory& trajectory() const { return trajectory_; }
  std::size_t marker_points() const { return marker_points_; }

 private:
  template <typename Condition>
  bool wait(Condition condition, double seconds = 20.0) {
    for (int i = 0; i < static_cast<int>(seconds / 0.05) && !condition(); ++i) {
      ros::spinOnce();
      ros::WallDuration(0.05).sleep();
    }
    return condition();
  }
  void on_trajectory(const trajectory_msgs::MultiDOFJointTrajectory& message) { trajectory_ = message; }
  void on_markers(const visualization_msgs::MarkerArray& message) {
    marker_points_ = message.markers.at(0).points.size();
  }

  ros::NodeHandle node_;
  std::map<std::string, ros::Publisher> publishers_;
  ros::Subscriber trajectories_, markers_;
  trajectory_msgs::MultiDOFJointTrajectory trajectory_;
  std::size_t marker_points_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "driver");
  const std::string file = argc > 1 ? argv[1] : "wall.bag";
  record(file);
  Player player;
  if (!player.play(file)) {
    std::printf("no answer from the node\n");
    return 1;
  }
  const char* fault =
      tern_test::fault_of(player.trajectory(), [](const auto& point) { return point.time_from_start.toSec(); });
  std::printf("%zu points, %zu points of the marker, fault: %s\n", player.trajectory().points.size(),
              player.marker_points(), fault == nullptr ? "none" : fault);
  return fault == nullptr && player.marker_points() == 201 ? 0 : 1;
}
