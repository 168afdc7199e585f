// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_VEHICLE_ARDUPILOT_CASCADE_HPP
#define TERN_HOST_VEHICLE_ARDUPILOT_CASCADE_HPP

#include "host/vehicle/controller.hpp"
#include "host/vehicle/guided_target.hpp"
#include "host/vehicle/rate_loop.hpp"

namespace tern_host {

/// `wanted` within the acceleration that ANGLE_MAX allows: across the motion first, along it what is left. m/s^2.
Eigen::Vector2d ardupilot_limited_lean(const Eigen::Vector2d& wanted, const Eigen::Vector2d& velocity);

/// A cascade in the manner of ArduPilot's guided mode with position, velocity and acceleration, with the gains and
/// limits that ArduPilot publishes as defaults: the target follows the stream with a limited jerk; position P by square
/// root, velocity PID; upright a PI on the acceleration; attitude by a shaped target that is fed forward, rates PID.
class ArdupilotCascade : public Controller {
 public:
  /// `start`: where it hovers. `begin`: the time of its first step. `tick`: seconds from one message to the next.
  /// `speed`: WPNAV_SPEED, m/s.
  ArdupilotCascade(const Setpoint& start, double begin, double tick, double speed);
  Wrench control(const Believed& state, double t, double step, const Setpoints& setpoints) override;

 private:
  void run(const Believed& state);
  void control_level(const Believed& state);
  void control_upright(const Believed& state);
  void control_attitude(const Believed& state);

  double tick_;
  double speed_;
  double next_message_;
  double next_loop_;
  double yaw_;
  double yaw_rate_ = 0.0;
  GuidedTarget target_;
  Lagging lagging_;
  Eigen::Vector2d lean_ = Eigen::Vector2d::Zero();   // acceleration, m/s^2
  Eigen::Vector2d slope_ = Eigen::Vector2d::Zero();  // of the velocity's error, filtered
  Eigen::Vector2d integral_ = Eigen::Vector2d::Zero();
  double last_climb_ = 0.0;
  double climb_off_ = 0.0;  // errors upright, filtered
  double effort_off_ = 0.0;
  double throttle_integral_ = 0.0;
  double throttle_;
  Eigen::Quaterniond attitude_;                        // the shaped target
  Eigen::Vector3d turning_ = Eigen::Vector3d::Zero();  // of the target, in its own frame
  Eigen::Vector3d wanted_rates_ = Eigen::Vector3d::Zero();
  RateLoop rates_;
};

}  // namespace tern_host

#endif
