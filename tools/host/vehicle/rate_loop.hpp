// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_VEHICLE_RATE_LOOP_HPP
#define TERN_HOST_VEHICLE_RATE_LOOP_HPP

#include <Eigen/Geometry>

namespace tern_host {

/// The part of a new value in a low pass of the first order. `cutoff` in Hz, `dt` in seconds.
double new_part(double cutoff, double dt);

/// `v`, each coordinate within `most`.
Eigen::Vector3d within(const Eigen::Vector3d& v, const Eigen::Vector3d& most);

/// `v`, no longer than `most`.
Eigen::Vector2d no_longer(const Eigen::Vector2d& v, double most);

/// The attitude whose z is `up`, a unit vector, and whose nose points along yaw, rad.
Eigen::Quaterniond attitude_of(const Eigen::Vector3d& up, double yaw);

/// Gains about the body's x, y and z. Outputs have no unit: 1 is all that the motors can give.
struct RateGains {
  Eigen::Vector3d p, i, d;
  Eigen::Vector3d most_integral;
  double d_cutoff;       ///< Hz
  double target_cutoff;  ///< Hz; 0: none
};

/// A PID on the body's rates, as both PX4 and ArduPilot have it.
class RateLoop {
 public:
  explicit RateLoop(const RateGains& gains) : gains_(gains) {}
  /// The torque to command, N m.
  Eigen::Vector3d torque(const Eigen::Vector3d& wanted, const Eigen::Vector3d& rates, double dt);

 private:
  RateGains gains_;
  Eigen::Vector3d target_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d integral_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d last_rates_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular_ = Eigen::Vector3d::Zero();  // acceleration, filtered
};

}  // namespace tern_host

#endif
