// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Stand-ins for the messages of MAVROS and of PX4's bridge: the fields that port/ros touches.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "messages.hpp"

namespace mavros_msgs::msg {
struct State {
  std_msgs::msg::Header header;
  bool connected = false, armed = false, guided = false;
  std::string mode;
};
struct PositionTarget {
  static constexpr std::uint8_t FRAME_LOCAL_NED = 1;
  std_msgs::msg::Header header;
  std::uint8_t coordinate_frame = 0;
  std::uint16_t type_mask = 0;
  geometry_msgs::msg::Point position;
  geometry_msgs::msg::Vector3 velocity, acceleration_or_force;
  float yaw = 0, yaw_rate = 0;
};
}  // namespace mavros_msgs::msg

namespace px4_msgs::msg {
struct OffboardControlMode {
  std::uint64_t timestamp = 0;
  bool position = false, velocity = false, acceleration = false, attitude = false, body_rate = false;
  bool thrust_and_torque = false, direct_actuator = false;
};
struct TrajectorySetpoint {
  std::uint64_t timestamp = 0;
  std::array<float, 3> position{}, velocity{}, acceleration{}, jerk{};
  float yaw = 0, yawspeed = 0;
};
struct VehicleOdometry {
  static constexpr std::uint8_t POSE_FRAME_NED = 1, POSE_FRAME_FRD = 2;
  std::uint64_t timestamp = 0, timestamp_sample = 0;
  std::uint8_t pose_frame = 0;
  std::array<float, 3> position{};
  std::array<float, 4> q{};
  std::uint8_t reset_counter = 0;
};
struct VehicleStatus {
  static constexpr std::uint8_t ARMING_STATE_DISARMED = 1, ARMING_STATE_ARMED = 2, NAVIGATION_STATE_OFFBOARD = 14;
  std::uint64_t timestamp = 0;
  std::uint8_t arming_state = 0, nav_state = 0;
};
}  // namespace px4_msgs::msg
