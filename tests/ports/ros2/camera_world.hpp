// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A vehicle with a camera in a world of the simulator, before the stand-ins for ROS 2.
#ifndef TERN_TESTS_PORTS_ROS2_CAMERA_WORLD_HPP
#define TERN_TESTS_PORTS_ROS2_CAMERA_WORLD_HPP

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>

#include "host/flight/depth_camera.hpp"
#include "host/flight/flight_world.hpp"
#include "ros2_core.hpp"
#include "tern_ros/inputs.hpp"
#include "tern_ros/outputs.hpp"

namespace tern_test {

using diagnostic_msgs::msg::DiagnosticArray;
using geometry_msgs::msg::PoseStamped;
using rclcpp::bus;
using trajectory_msgs::msg::MultiDOFJointTrajectory;

inline constexpr std::int64_t kTick = 10000000;

inline PoseStamped pose_at(double x, double y, double z, const char* frame = "map") {
  PoseStamped pose;
  pose.header.frame_id = frame;
  tern_ros::set_stamp(pose.header.stamp, bus().now());
  pose.pose.position = {x, y, z};
  pose.pose.orientation.w = 1.0;
  return pose;
}

/// A tick of the clock, and the node's timer.
inline void tick() {
  bus().set_clock(bus().now() + kTick);
  for (const auto& timer : bus().timers) timer();
}

/// What the node's diagnostics say.
inline std::string told() {
  const auto message = std::any_cast<DiagnosticArray>(bus().last("/diagnostics"));
  return message.status.at(0).message;
}

/// A vehicle with a camera in a world of the simulator, which follows exactly.
class CameraWorld {
 public:
  explicit CameraWorld(const char* member) : world_(tern_host::read_flight_world(member, {})), noise_(1) {
    const tern_host::FlightSettings& s = world_.settings;
    position_ = world_.start;
    yaw_ = std::atan2(world_.goal.y - position_.y, world_.goal.x - position_.x);
    auto& p = bus().parameters;
    p["cell"] = s.cell;
    p["window_x"] = s.window.x;
    p["window_y"] = s.window.y;
    p["window_z"] = s.window.z;
    p["radius"] = s.body_radius;
    p["range"] = s.sensor_range;
    p["horizon"] = 0.8 * s.sensor_range;
    p["speed"] = p["climb"] = p["sink"] = s.v_max;
    p["acceleration"] = p["acceleration_z"] = s.a_max;
    p["jerk"] = s.j_max;
    p["yaw_rate"] = s.yaw_rate;
    p["yaw_acceleration"] = s.yaw_acceleration;
    p["camera.most"] = 1000.0;
    geometry_msgs::msg::Transform mounting;
    mounting.rotation = {-0.5, 0.5, -0.5, 0.5};
    bus().transforms["base_link camera_optical"] = mounting;
  }
  void send_goal() const { bus().deliver("goal", pose_at(world_.goal.x, world_.goal.y, world_.goal.z)); }
  void step() {
    send_odometry();
    if (steps_++ % 3 == 0) send_frame();
    tick();
    const std::any last = bus().last("command/trajectory");
    if (!last.has_value()) return;
    const auto setpoint = std::any_cast<MultiDOFJointTrajectory>(last);
    sent[tern_ros::stamp_of(setpoint.header.stamp)] = setpoint.points.at(0);
    const auto& t = setpoint.points.at(0).transforms.at(0);
    position_ = {t.translation.x, t.translation.y, t.translation.z};
    yaw_ = 2.0 * std::atan2(t.rotation.z, t.rotation.w);
    least = std::min(least, tern_host::clearance(world_, position_));
  }
  double body() const { return world_.settings.body_radius; }
  double least = 1e9;
  std::map<std::int64_t, trajectory_msgs::msg::MultiDOFJointTrajectoryPoint> sent;  // by their stamps

 private:
  void send_odometry() const {
    nav_msgs::msg::Odometry odometry;
    const PoseStamped pose = pose_at(position_.x, position_.y, position_.z);
    odometry.header = pose.header;
    odometry.child_frame_id = "base_link";
    odometry.pose.pose = pose.pose;
    odometry.pose.pose.orientation = {0.0, 0.0, std::sin(0.5 * yaw_), std::cos(0.5 * yaw_)};
    bus().deliver("odometry", odometry);
  }
  void send_frame() {
    const tern_host::DepthFrame frame = tern_host::take_frame(world_, position_, yaw_, bus().now(), noise_);
    sensor_msgs::msg::CameraInfo info;
    info.width = static_cast<std::uint32_t>(frame.view.width);
    info.height = static_cast<std::uint32_t>(frame.view.height);
    info.p = {frame.view.fx, 0.0, frame.view.cx, 0.0, 0.0, frame.view.fy, frame.view.cy, 0.0, 0.0, 0.0, 1.0, 0.0};
    bus().deliver("camera/camera_info", info);
    sensor_msgs::msg::Image image;
    image.header.frame_id = "camera_optical";
    tern_ros::set_stamp(image.header.stamp, bus().now());
    image.width = info.width;
    image.height = info.height;
    image.encoding = "16UC1";
    image.step = 2 * image.width;
    for (const float depth : frame.depths) {
      const int mm = static_cast<int>(std::min(60.0f, depth) * 1000.0f);
      image.data.push_back(static_cast<std::uint8_t>(mm & 255));
      image.data.push_back(static_cast<std::uint8_t>(mm / 256));
    }
    bus().deliver("camera/image", image);
  }

  tern_host::FlightWorld world_;
  tern_host::Noise noise_;
  tern::Vec3 position_{};
  double yaw_ = 0.0;
  int steps_ = 0;
};

}  // namespace tern_test

#endif
