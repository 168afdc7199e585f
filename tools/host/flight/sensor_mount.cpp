// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/sensor_mount.hpp"

#include <Eigen/Geometry>

namespace tern_host {

std::array<double, 4> level_attitude(double yaw) {
  return {std::cos(0.5 * yaw), 0.0, 0.0, std::sin(0.5 * yaw)};
}

tern::Pose camera_pose(const SensorMount& mount, const tern::Vec3& position, const std::array<double, 4>& attitude,
                       double gimbal) {
  const Eigen::Quaterniond body(attitude[0], attitude[1], attitude[2], attitude[3]);
  const double up = mount.pitch + gimbal;
  const Eigen::Quaterniond pitched(std::cos(0.5 * up), 0.0, -std::sin(0.5 * up), 0.0);
  const Eigen::Quaterniond axes(0.5, -0.5, 0.5, -0.5);  // from the camera's (right, down, ahead)
  const Eigen::Quaterniond q = (body * pitched * axes).normalized();
  const Eigen::Vector3d off = body * Eigen::Vector3d(mount.offset.x, mount.offset.y, mount.offset.z);
  return {{position.x + off.x(), position.y + off.y(), position.z + off.z()}, {q.w(), q.x(), q.y(), q.z()}};
}

}  // namespace tern_host
