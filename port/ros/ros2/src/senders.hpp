// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What sends setpoints from the ROS 2 node: to controllers, to MAVROS, or to PX4's bridge. The packages of the last two
// may be missing.
#ifndef TERN_ROS_SENDERS_HPP
#define TERN_ROS_SENDERS_HPP

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_lifecycle/lifecycle_node.hpp>
#include <trajectory_msgs/msg/multi_dof_joint_trajectory.hpp>
#include <utility>
#include <vector>
#if __has_include(<mavros_msgs/msg/position_target.hpp>)
#include <mavros_msgs/msg/position_target.hpp>
#include <mavros_msgs/msg/state.hpp>
#define TERN_ROS_HAS_MAVROS
#endif
#if __has_include(<px4_msgs/msg/trajectory_setpoint.hpp>)
#include <px4_msgs/msg/offboard_control_mode.hpp>
#include <px4_msgs/msg/trajectory_setpoint.hpp>
#include <px4_msgs/msg/vehicle_odometry.hpp>
#include <px4_msgs/msg/vehicle_status.hpp>
#define TERN_ROS_HAS_PX4
#endif

#include "tern_onboard/onboard.hpp"
#include "tern_ros/flight_topics.hpp"
#include "tern_ros/outputs.hpp"

namespace tern_ros {

using Send = std::function<void(std::int64_t now, const tern_onboard::Setpoint&)>;

/// The node's parts, which outlive the sender.
struct SenderParts {
  rclcpp_lifecycle::LifecycleNode& node;
  tern_onboard::Onboard& onboard;
  FlightTopics& topics;
  const Options& options;
  std::vector<rclcpp::SubscriptionBase::SharedPtr>& subscriptions;

  /// Listens to what an autopilot says, as sensor data.
  template <typename Message, typename Handle>
  void on(const char* topic, Handle handle) const {
    subscriptions.push_back(node.create_subscription<Message>(topic, rclcpp::SensorDataQoS(),
                                                              [handle](const Message& message) { handle(message); }));
  }
};

/// Sends with `write` filling in a Message with a header.
template <typename Message, typename Write>
Send make_stamped_sender(const SenderParts& parts, const char* topic, Write write) {
  const auto publisher = parts.node.create_publisher<Message>(topic, rclcpp::QoS(4));
  return [publisher, write, frame = parts.options.frame](std::int64_t now, const tern_onboard::Setpoint& setpoint) {
    if (!setpoint.valid) return;
    Message message;
    write(setpoint, message);
    message.header.frame_id = frame;
    set_stamp(message.header.stamp, now);
    publisher->publish(message);
  };
}

#ifdef TERN_ROS_HAS_MAVROS
inline Send make_mavros_sender(const SenderParts& parts) {
  using mavros_msgs::msg::PositionTarget;
  using mavros_msgs::msg::State;
  tern_onboard::Onboard& onboard = parts.onboard;
  onboard.set_following(false);  // until the autopilot says so
  parts.on<State>("mavros/state",
                  [&onboard](const State& message) { onboard.set_following(follows_setpoints(message)); });
  return make_stamped_sender<PositionTarget>(
      parts, "mavros/setpoint_raw/local",
      [](const auto& setpoint, auto& message) { write_position_target(setpoint, message); });
}
#endif

#ifdef TERN_ROS_HAS_PX4
/// PX4 wants the mode's heartbeat always. The topic of setpoints is also the autopilot's own: what is sent there in
/// another mode would fight with its setpoints.
inline Send make_px4_sender(const SenderParts& parts) {
  using px4_msgs::msg::VehicleOdometry;
  using px4_msgs::msg::VehicleStatus;
  rclcpp_lifecycle::LifecycleNode& node = parts.node;
  tern_onboard::Onboard& onboard = parts.onboard;
  const auto follows = std::make_shared<std::atomic<bool>>(false);
  onboard.set_following(false);
  parts.on<VehicleOdometry>("fmu/out/vehicle_odometry",
                            [&node, &topics = parts.topics](const VehicleOdometry& message) {
                              topics.on_px4_odometry(message, node.now().nanoseconds());
                            });
  parts.on<VehicleStatus>("fmu/out/vehicle_status", [&onboard, follows](const VehicleStatus& message) {
    *follows = message.arming_state == VehicleStatus::ARMING_STATE_ARMED &&
               message.nav_state == VehicleStatus::NAVIGATION_STATE_OFFBOARD;
    onboard.set_following(*follows);
  });
  const auto modes = node.create_publisher<px4_msgs::msg::OffboardControlMode>("fmu/in/offboard_control_mode", 4);
  const auto setpoints = node.create_publisher<px4_msgs::msg::TrajectorySetpoint>("fmu/in/trajectory_setpoint", 4);
  return [modes, setpoints, follows](std::int64_t now, const tern_onboard::Setpoint& setpoint) {
    if (!setpoint.valid) return;
    px4_msgs::msg::OffboardControlMode mode;
    write_px4_mode(now, mode);
    modes->publish(mode);
    if (!*follows) return;
    px4_msgs::msg::TrajectorySetpoint message;
    write_px4_setpoint(setpoint, message);
    setpoints->publish(message);
  };
}
#endif

/// The sender for Options::output; nothing if the node was built without what it takes.
inline Send make_sender(const SenderParts& parts) {
#ifdef TERN_ROS_HAS_MAVROS
  if (parts.options.output == "mavros") return make_mavros_sender(parts);
#endif
#ifdef TERN_ROS_HAS_PX4
  if (parts.options.output == "px4") return make_px4_sender(parts);
#endif
  if (parts.options.output != "multidof") return {};
  return make_stamped_sender<trajectory_msgs::msg::MultiDOFJointTrajectory>(
      parts, "command/trajectory", [](const auto& setpoint, auto& message) { write_setpoint(setpoint, message); });
}

}  // namespace tern_ros

#endif
