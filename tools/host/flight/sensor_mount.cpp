// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/sensor_mount.hpp"

#include <Eigen/Geometry>

namespace tern_host {
namespace {

/// A sensor that is turned and pitched up, and whose axes `axes` turns into the vehicle's.
tern::Pose pose_of(const SensorMount& mount, const tern::Vec3& position, const std::array<double, 4>& attitude,
                   double up, const Eigen::Quaterniond& axes) {
  const Eigen::Quaterniond body(attitude[0], attitude[1], attitude[2], attitude[3]);
  const Eigen::Quaterniond pitched(std::cos(0.5 * up), 0.0, -std::sin(0.5 * up), 0.0);
  const Eigen::Quaterniond turned(std::cos(0.5 * mount.turn), 0.0, 0.0, std::sin(0.5 * mount.turn));
  const Eigen::Quaterniond q = (body * turned * pitched * axes).normalized();
  const Eigen::Vector3d off = body * Eigen::Vector3d(mount.offset.x, mount.offset.y, mount.offset.z);
  return {{position.x + off.x(), position.y + off.y(), position.z + off.z()}, {q.w(), q.x(), q.y(), q.z()}};
}

}  // namespace

std::array<double, 4> level_attitude(double yaw) {
  return {std::cos(0.5 * yaw), 0.0, 0.0, std::sin(0.5 * yaw)};
}

tern::Pose lidar_pose(const SensorMount& mount, const tern::Vec3& position, const std::array<double, 4>& attitude) {
  return pose_of(mount, position, attitude, mount.pitch, Eigen::Quaterniond::Identity());
}

tern::Vec3 turned(const tern::Pose& sensor, const tern::Vec3& vector) {
  const double(&q)[4] = sensor.quaternion;
  const Eigen::Vector3d v = Eigen::Quaterniond(q[0], q[1], q[2], q[3]) * Eigen::Vector3d(vector.x, vector.y, vector.z);
  return {v.x(), v.y(), v.z()};
}

tern::Pose camera_pose(const SensorMount& mount, const tern::Vec3& position, const std::array<double, 4>& attitude,
                       double gimbal) {
  // From the camera's axes: right, down, ahead.
  return pose_of(mount, position, attitude, mount.pitch + gimbal, Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5));
}

}  // namespace tern_host
