// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_VEHICLE_PX4_CASCADE_HPP
#define TERN_HOST_VEHICLE_PX4_CASCADE_HPP

#include "host/vehicle/geometric_controller.hpp"

namespace tern_host {

/// A cascade in the manner of PX4's multicopter controllers, with the gains that PX4 publishes as defaults: position P,
/// velocity PID with position, velocity and acceleration fed forward, attitude P on the reduced attitude, rates PID.
/// Setpoints come as a stream and are held in between. World frame with z up, body x ahead and y left.
class Px4Cascade {
 public:
  /// `tick`: seconds from one setpoint to the next. `speed_max`: MPC_XY_VEL_MAX, m/s.
  Px4Cascade(double tick, double speed_max) : tick_(tick), speed_max_(speed_max) {}
  /// One step of the rate loop, at time t; the slower loops run when their time has come.
  Wrench control(const Believed& state, double t, double step, const Setpoints& setpoints);

 private:
  void control_position(const Believed& state, double dt);
  void control_attitude(const Believed& state);
  Eigen::Vector3d control_rates(const Believed& state, double dt);

  double tick_;
  double speed_max_;
  double next_setpoint_ = 0.0;
  double next_attitude_ = 0.0;
  Setpoint setpoint_{};
  Eigen::Vector3d acceleration_ = Eigen::Vector3d::Zero();  // estimate, filtered
  Eigen::Vector3d last_velocity_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity_integral_ = Eigen::Vector3d::Zero();
  Eigen::Quaterniond wanted_ = Eigen::Quaterniond::Identity();
  double thrust_ = 0.0;  // N
  Eigen::Vector3d wanted_rates_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d rates_integral_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d last_rates_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular_ = Eigen::Vector3d::Zero();  // acceleration, filtered
};

}  // namespace tern_host

#endif
