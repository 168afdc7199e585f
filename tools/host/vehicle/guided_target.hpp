// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_VEHICLE_GUIDED_TARGET_HPP
#define TERN_HOST_VEHICLE_GUIDED_TARGET_HPP

#include <Eigen/Core>

#include "tern/trajectory.hpp"

namespace tern_host {

struct Motion {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
};

/// Where the loops behind the target are at their limits, and how far the body is off. A target does not run away from
/// a body that cannot follow.
struct Lagging {
  Eigen::Vector3d limit = Eigen::Vector3d::Zero();  ///< the direction at its limit; 0: none. Upright for itself
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
};

/// What ArduPilot makes of a stream of positions, velocities and accelerations in guided mode: it goes on with the last
/// message until the next, and follows it with a limited jerk. Corrections are limited in speed and acceleration, what
/// the messages ask for is not. World frame, SI units.
class GuidedTarget {
 public:
  /// At rest at a position. `speed`: WPNAV_SPEED.
  GuidedTarget(const Eigen::Vector3d& position, double speed);
  void take(const tern::Sample& message);
  void advance(double dt, const Lagging& lagging);
  /// The body is further away than the position controller may correct: the target comes nearer.
  void pull_to(const Eigen::Vector3d& position) { desired_.position = position; }
  const Motion& desired() const { return desired_; }

 private:
  void move(double dt, const Lagging& lagging);
  void shape_level(double dt);
  void shape_upright(double dt);

  double speed_;
  Motion message_;
  Motion desired_;
};

/// WPNAV_ACCEL and WPNAV_ACCEL_Z, which limit corrections, m/s^2.
constexpr double kArdupilotAcceleration = 2.5;
constexpr double kArdupilotAccelerationZ = 1.0;
constexpr double kArdupilotUp = 2.5;    // WPNAV_SPEED_UP, m/s
constexpr double kArdupilotDown = 1.5;  // WPNAV_SPEED_DN

}  // namespace tern_host

#endif
