// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights as bags: what a world publishes and the node's setpoints are written to one, and played to a new node.
#include <geometry_msgs/PoseStamped.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

#include <algorithm>
#include <cmath>

#include "ros1/flown_world.hpp"

namespace tern_test {
namespace {

constexpr double kAgrees = 0.1;  // m

}  // namespace

class FlightBag {
 public:
  FlightBag(const std::string& file, rosbag::BagMode mode) : bag(file, mode) {}
  rosbag::Bag bag;
};

void Outlet::record(const std::string& file) {
  bag_ = std::make_shared<FlightBag>(file, rosbag::bagmode::Write);
}

template <typename Message>
void Outlet::note(const std::string& topic, const Message& message, std::int64_t now) {
  if (bag_ != nullptr) bag_->bag.write(topic, time_of(now), message);
}
template void Outlet::note(const std::string&, const rosgraph_msgs::Clock&, std::int64_t);
template void Outlet::note(const std::string&, const nav_msgs::Odometry&, std::int64_t);
template void Outlet::note(const std::string&, const sensor_msgs::CameraInfo&, std::int64_t);
template void Outlet::note(const std::string&, const sensor_msgs::Image&, std::int64_t);
template void Outlet::note(const std::string&, const sensor_msgs::PointCloud2&, std::int64_t);
template void Outlet::note(const std::string&, const geometry_msgs::PoseStamped&, std::int64_t);
template void Outlet::note(const std::string&, const tf2_msgs::TFMessage&, std::int64_t);
template void Outlet::note(const std::string&, const trajectory_msgs::MultiDOFJointTrajectory&, std::int64_t);

/// The vehicle of the bag flew the setpoints of its own flight. The node gets the same messages, though not always in
/// the same tick: sooner or later it plans otherwise.
Flown FlownWorld::play(const std::string& file) {
  FlightBag played(file, rosbag::bagmode::Read);
  std::map<std::string, ros::Publisher> publishers = sensors_.publishers();
  publishers[odometry_.getTopic()] = odometry_;
  publishers[goal_.getTopic()] = goal_;
  publishers[tf_.getTopic()] = tf_;
  publish_clock();
  ros::WallDuration(0.1).sleep();
  for (const rosbag::MessageInstance& message : rosbag::View(played.bag)) {
    if (const auto clock = message.instantiate<rosgraph_msgs::Clock>()) {
      now_ = static_cast<std::int64_t>(clock->clock.toNSec());
      clock_.publish(*clock);
      if (!wait_for_setpoint()) ++flown_.late;
    } else if (const auto setpoint = message.instantiate<trajectory_msgs::MultiDOFJointTrajectory>()) {
      // The node's own for this time is there: the clock waited for it.
      const auto& p = setpoint->points.at(0).transforms.at(0).translation;
      const tern::Vec3& s = setpoint_.sample.position;
      if (static_cast<std::int64_t>(setpoint->header.stamp.toNSec()) != setpoint_stamp_ || setpoint_time_ == 0.0)
        continue;
      flown_.off = std::max(flown_.off, std::hypot(p.x - s.x, std::hypot(p.y - s.y, p.z - s.z)));
      if (flown_.off < kAgrees) flown_.agreed = seconds();
    } else {
      publishers.at(message.getTopic()).publish(message);
    }
  }
  flown_.time = seconds();
  const tern::Vec3 &s = setpoint_.sample.position, &goal = world_.goal;
  flown_.end = std::hypot(s.x - goal.x, std::hypot(s.y - goal.y, s.z - goal.z)) < 0.02 ? "reached" : "elsewhere";
  return flown_;
}

}  // namespace tern_test
