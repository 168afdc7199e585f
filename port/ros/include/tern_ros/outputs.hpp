// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Setpoints as messages of autopilots and controllers.
#ifndef TERN_ROS_OUTPUTS_HPP
#define TERN_ROS_OUTPUTS_HPP

#include <cmath>
#include <cstdint>

#include "tern/tern.hpp"
#include "tern_onboard/onboard.hpp"
#include "tern_stacks/stacks.hpp"

namespace tern_ros {

/// Sets a stamp, as stamp_of() reads it.
template <typename Time>
auto set_stamp(Time& time, std::int64_t ns) -> decltype(time.nanosec, void()) {
  time.sec = static_cast<decltype(time.sec)>(ns / 1000000000);
  time.nanosec = static_cast<decltype(time.nanosec)>(ns % 1000000000);
}
template <typename Time>
auto set_stamp(Time& time, std::int64_t ns) -> decltype(time.nsec, void()) {
  time.sec = static_cast<decltype(time.sec)>(ns / 1000000000);
  time.nsec = static_cast<decltype(time.nsec)>(ns % 1000000000);
}

template <typename Vector>
void set_vector(Vector& out, const tern::Vec3& v) {
  out.x = v.x;
  out.y = v.y;
  out.z = v.z;
}

/// A setpoint as trajectory_msgs/MultiDOFJointTrajectory with one point: pose, velocity and acceleration in the world
/// frame. The attitude is the heading alone; controllers find the tilt from the acceleration.
template <typename MultiDofTrajectory>
void write_setpoint(const tern_onboard::Setpoint& setpoint, MultiDofTrajectory& message) {
  message.joint_names.assign(1, "base_link");
  message.points.resize(1);
  auto& point = message.points[0];
  point.transforms.resize(1);
  point.velocities.resize(1);
  point.accelerations.resize(1);
  set_vector(point.transforms[0].translation, setpoint.position);
  point.transforms[0].rotation.w = std::cos(0.5 * setpoint.yaw);
  point.transforms[0].rotation.z = std::sin(0.5 * setpoint.yaw);
  set_vector(point.velocities[0].linear, setpoint.velocity);
  point.velocities[0].angular.z = setpoint.yaw_rate;
  set_vector(point.accelerations[0].linear, setpoint.acceleration);
}

/// A setpoint as mavros_msgs/PositionTarget. MAVROS takes east, north, up in it, despite the name of the frame.
template <typename PositionTarget>
void write_position_target(const tern_onboard::Setpoint& setpoint, PositionTarget& message) {
  message.coordinate_frame = PositionTarget::FRAME_LOCAL_NED;
  message.type_mask = 0;  // all fields count, and acceleration is not a force
  set_vector(message.position, setpoint.position);
  set_vector(message.velocity, setpoint.velocity);
  set_vector(message.acceleration_or_force, setpoint.acceleration);
  message.yaw = static_cast<float>(std::remainder(setpoint.yaw, 2.0 * std::acos(-1.0)));
  message.yaw_rate = static_cast<float>(setpoint.yaw_rate);
}

/// A setpoint as px4_msgs/TrajectorySetpoint: north, east, down, with the origin of the odometry.
template <typename TrajectorySetpoint>
void write_px4_setpoint(const tern_onboard::Setpoint& setpoint, TrajectorySetpoint& message) {
  const tern::Sample sample{setpoint.position, setpoint.velocity, setpoint.acceleration, setpoint.jerk, {}};
  const tern::YawSample yaw{{std::cos(setpoint.yaw), std::sin(setpoint.yaw), setpoint.yaw_rate}, 0.0, setpoint.yaw};
  const tern::SetpointNed ned = tern::setpoint_ned(sample, yaw, {0.0, 0.0, 0.0});
  for (std::size_t k = 0; k < 3; ++k) {
    message.position[k] = ned.position[k];
    message.velocity[k] = ned.velocity[k];
    message.acceleration[k] = ned.acceleration[k];
    message.jerk[k] = ned.jerk[k];
  }
  message.yaw = ned.yaw;
  message.yawspeed = ned.yaw_rate;
  message.timestamp = static_cast<decltype(message.timestamp)>(setpoint.time / 1000);
}

/// The px4_msgs/OffboardControlMode that goes with it: PX4 wants it twice a second at least, also before the mode.
template <typename OffboardControlMode>
void write_px4_mode(std::int64_t now, OffboardControlMode& message) {
  message.position = message.velocity = message.acceleration = true;
  message.attitude = message.body_rate = false;
  message.timestamp = static_cast<decltype(message.timestamp)>(now / 1000);
}

}  // namespace tern_ros

#endif
