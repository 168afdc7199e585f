// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights as bags: what a world publishes is written to one, and a node that is played the bag must fly the same way.
#include <geometry_msgs/PoseStamped.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/CameraInfo.h>

#include <algorithm>
#include <cmath>

#include "ros1/flown_world.hpp"

namespace tern_test {

class FlightBag {
 public:
  FlightBag(const std::string& file, rosbag::BagMode mode) : bag(file, mode) {}
  rosbag::Bag bag;
};

void FlownWorld::record(const std::string& file) {
  bag_ = std::make_shared<FlightBag>(file, rosbag::bagmode::Write);
}

template <typename Message>
void FlownWorld::publish(const ros::Publisher& publisher, const Message& message) {
  publisher.publish(message);
  if (bag_ == nullptr) return;
  ros::Time time;
  time.fromNSec(static_cast<std::uint64_t>(now_));
  bag_->bag.write(publisher.getTopic(), time, message);
}
template void FlownWorld::publish(const ros::Publisher&, const rosgraph_msgs::Clock&);
template void FlownWorld::publish(const ros::Publisher&, const nav_msgs::Odometry&);
template void FlownWorld::publish(const ros::Publisher&, const sensor_msgs::CameraInfo&);
template void FlownWorld::publish(const ros::Publisher&, const sensor_msgs::Image&);
template void FlownWorld::publish(const ros::Publisher&, const geometry_msgs::PoseStamped&);

/// The vehicle of the bag flew the setpoints of its own flight. The node gets the same messages, though not always in
/// the same tick, so it plans nearly the same.
Flown FlownWorld::play(const std::string& file) {
  FlightBag played(file, rosbag::bagmode::Read);
  publish_clock();
  ros::WallDuration(0.1).sleep();
  for (const rosbag::MessageInstance& message : rosbag::View(played.bag)) {
    if (const auto odometry = message.instantiate<nav_msgs::Odometry>()) {
      odometry_.publish(*odometry);
      const auto& p = odometry->pose.pose.position;
      const auto& s = setpoint_.sample.position;
      flown_.off = std::max(flown_.off, std::hypot(p.x - s.x, std::hypot(p.y - s.y, p.z - s.z)));
    } else if (const auto info = message.instantiate<sensor_msgs::CameraInfo>()) {
      lens_.publish(*info);
    } else if (const auto image = message.instantiate<sensor_msgs::Image>()) {
      image_.publish(*image);
    } else if (const auto goal = message.instantiate<geometry_msgs::PoseStamped>()) {
      goal_.publish(*goal);
    } else if (const auto clock = message.instantiate<rosgraph_msgs::Clock>()) {
      now_ = static_cast<std::int64_t>(clock->clock.toNSec());
      clock_.publish(*clock);
      if (!wait_for_setpoint()) ++flown_.late;
    }
  }
  flown_.time = seconds();
  const tern::Vec3 &s = setpoint_.sample.position, &goal = world_.goal;
  flown_.end = std::hypot(s.x - goal.x, std::hypot(s.y - goal.y, s.z - goal.z)) < 0.02 ? "reached" : "elsewhere";
  return flown_;
}

}  // namespace tern_test
