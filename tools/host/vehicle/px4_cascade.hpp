// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_VEHICLE_PX4_CASCADE_HPP
#define TERN_HOST_VEHICLE_PX4_CASCADE_HPP

#include "host/vehicle/controller.hpp"
#include "host/vehicle/rate_loop.hpp"

namespace tern_host {

/// A thrust for each unit of mass, as PX4 limits it: at most twice the weight, upright before sideways, but with some
/// sideways left. m/s^2, z up.
Eigen::Vector3d px4_limited_thrust(const Eigen::Vector3d& thrust);

/// The thrust for each unit of mass that PX4 asks for to accelerate by `wanted`, m/s^2: tilted by at most 45 degrees,
/// and by what a thrust that carries the weight alone would need; at least 0.24 of the weight.
Eigen::Vector3d px4_asked_thrust(const Eigen::Vector3d& wanted);

/// A cascade in the manner of PX4's multicopter controllers, with the gains and limits that PX4 publishes as defaults:
/// position P, velocity PID with position, velocity and acceleration fed forward, attitude P on the reduced attitude,
/// rates PID. Setpoints come as a stream and are held in between. World frame with z up, body x ahead and y left.
class Px4Cascade : public Controller {
 public:
  /// `begin`: the time of its first step. `tick`: seconds from one setpoint to the next. `speed_max`: MPC_XY_VEL_MAX,
  /// m/s.
  Px4Cascade(double begin, double tick, double speed_max);
  Wrench control(const Believed& state, double t, double step, const Setpoints& setpoints) override;

 private:
  void control_position(const Believed& state, double dt);
  void integrate(Eigen::Vector3d off, const Eigen::Vector3d& wanted, double dt);
  void control_attitude(const Believed& state);

  double tick_;
  double speed_max_;
  double next_setpoint_;
  double next_position_;
  double next_attitude_;
  Setpoint setpoint_{};
  Eigen::Vector3d acceleration_ = Eigen::Vector3d::Zero();  // estimate, filtered
  Eigen::Vector3d last_velocity_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity_integral_ = Eigen::Vector3d::Zero();
  Eigen::Quaterniond wanted_ = Eigen::Quaterniond::Identity();
  double thrust_ = 0.0;  // N
  Eigen::Vector3d wanted_rates_ = Eigen::Vector3d::Zero();
  RateLoop rates_;
};

}  // namespace tern_host

#endif
