// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights as bags: what a world publishes and the node's setpoints are written to one, played to a new node, and
// compared with the node's record.
#include <geometry_msgs/PoseStamped.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>

#include "host/flight/flight_replay.hpp"
#include "host/text_records.hpp"
#include "ros1/flown_world.hpp"

namespace tern_test {
namespace {

constexpr double kAgrees = 0.1;  // m

constexpr std::size_t kMostBytes = std::size_t{1} << 30;  // of a record

using trajectory_msgs::MultiDOFJointTrajectory;

/// The setpoints of a bag, by their stamps.
std::map<std::int64_t, trajectory_msgs::MultiDOFJointTrajectoryPoint> setpoints_of(const std::string& file) {
  std::map<std::int64_t, trajectory_msgs::MultiDOFJointTrajectoryPoint> setpoints;
  const rosbag::Bag bag(file);
  for (const rosbag::MessageInstance& message : rosbag::View(bag)) {
    const auto setpoint = message.instantiate<MultiDOFJointTrajectory>();
    if (setpoint) setpoints[static_cast<std::int64_t>(setpoint->header.stamp.toNSec())] = setpoint->points.at(0);
  }
  return setpoints;
}

template <typename Vector>
bool equal(const Vector& a, const tern::Vec3& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

}  // namespace

int replay(const std::string& record, const std::string& bag) try {
  std::map<std::int64_t, trajectory_msgs::MultiDOFJointTrajectoryPoint> setpoints;
  if (!bag.empty()) setpoints = setpoints_of(bag);
  int compared = 0, different = 0;
  const auto on_tick = [&](const tern_host::ReplayedTick& tick) {
    const auto found = setpoints.find(tick.t);
    if (found == setpoints.end()) return;
    const auto& point = found->second;
    const tern::Sample& commanded = tick.command.sample;
    const bool same = equal(point.transforms.at(0).translation, commanded.position) &&
                      equal(point.velocities.at(0).linear, commanded.velocity) &&
                      equal(point.accelerations.at(0).linear, commanded.acceleration);
    ++compared;
    different += same ? 0 : 1;
  };
  const tern_host::FlightReplay flown = tern_host::replay_flight(tern_host::read_bytes(record, kMostBytes), on_tick);
  std::printf("{\"ticks\": %d, \"frames\": %d, \"compared\": %d, \"different\": %d, \"difference\": \"%s\"}\n",
              flown.ticks, flown.frames, compared, different, flown.difference.c_str());
  return flown.difference.empty() && different == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}

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
template void Outlet::note(const std::string&, const MultiDOFJointTrajectory&, std::int64_t);

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
    } else if (const auto setpoint = message.instantiate<MultiDOFJointTrajectory>()) {
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
