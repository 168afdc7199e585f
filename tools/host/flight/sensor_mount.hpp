// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_SENSOR_MOUNT_HPP
#define TERN_HOST_FLIGHT_SENSOR_MOUNT_HPP

#include <array>
#include <cmath>
#include <string>

#include "tern/map.hpp"
#include "tern/vec3.hpp"

namespace tern_host {

/// Where a sensor is on the vehicle, and how it looks from there. Metres and rad.
struct SensorMount {
  std::string kind = "level";  ///< turns about the vertical alone; or body: tilts with the vehicle
  tern::Vec3 offset{};         ///< of the sensor from the vehicle's centre: ahead, left, up
  double turn = 0.0;           ///< to the left of the vehicle's nose
  double pitch = 0.0;          ///< of its axis above the vehicle's level
  double gimbal_low = 0.0;     ///< how far a gimbal pitches it down and up from there; equal where none does
  double gimbal_high = 0.0;

  /// A camera in the vehicle's centre that looks level.
  bool is_plain() const {
    return kind == "level" && std::hypot(offset.x, offset.y, offset.z) <= 0.0 && std::hypot(turn, pitch) <= 0.0 &&
           std::abs(gimbal_low) <= 0.0 && std::abs(gimbal_high) <= 0.0;
  }
};

/// The unit quaternion (w, x, y, z) of a vehicle that is level.
std::array<double, 4> level_attitude(double yaw);

/// The pose of a lidar, whose axes are those of the vehicle when it is not pitched.
tern::Pose lidar_pose(const SensorMount& mount, const tern::Vec3& position, const std::array<double, 4>& attitude);

/// A vector of a sensor's own axes in the world's.
tern::Vec3 turned(const tern::Pose& sensor, const tern::Vec3& vector);

/// The pose of a camera on a vehicle at `position`, whose axes (x ahead, y left, z along its thrust) `attitude` turns
/// into the world's. `gimbal`: how far the gimbal pitches the camera up, rad.
tern::Pose camera_pose(const SensorMount& mount, const tern::Vec3& position, const std::array<double, 4>& attitude,
                       double gimbal);

}  // namespace tern_host

#endif
