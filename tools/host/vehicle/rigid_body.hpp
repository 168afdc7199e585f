// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A quadrotor as a rigid body: four motors with lag, drag in moving air, attitude as a quaternion. Drag is level alone:
// rotors, from which most of it comes, hardly resist motion along their axes.
#ifndef TERN_HOST_VEHICLE_RIGID_BODY_HPP
#define TERN_HOST_VEHICLE_RIGID_BODY_HPP

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>

#include "tern/vec3.hpp"

namespace tern_host {

inline Eigen::Vector3d to_eigen(const tern::Vec3& v) {
  return {v.x, v.y, v.z};
}

/// A quadrotor of 1 kg in the form of an X, of the size of a body radius of 0.25 m. SI units.
struct Body {
  static constexpr double kMass = 1.0;
  static constexpr double kArm = 0.12;              ///< of a motor along x and along y
  static constexpr double kTorqueOfThrust = 0.016;  ///< about the thrust, of a propeller
  static constexpr double kMotorLag = 0.015;
  static constexpr double kDrag = 0.1;  ///< level deceleration a speed through the air, 1/s; what a controller believes
  static constexpr double kThrustToWeight = 4.0;
  static Eigen::Vector3d inertia() { return {0.004, 0.004, 0.007}; }
};

/// Force along the body's z and torque, in the body's frame (x ahead, y left).
struct Wrench {
  double thrust;
  Eigen::Vector3d torque;
};

class RigidBody {
 public:
  /// Level, with thrust that carries its weight. `drag`: its true drag, as Body::kDrag.
  RigidBody(const Eigen::Vector3d& position, const Eigen::Vector3d& velocity, double yaw, double drag);

  /// What the motors are told; what is beyond their range is cut off.
  void command(const Wrench& wrench);
  /// Moves on by `step` seconds in air that moves with `wind`.
  void advance(double step, const Eigen::Vector3d& wind);

  Eigen::Vector3d position() const { return vector(0); }
  Eigen::Vector3d velocity() const { return vector(3); }
  Eigen::Quaterniond attitude() const { return {state_[6], state_[7], state_[8], state_[9]}; }
  Eigen::Vector3d body_rates() const { return vector(10); }

 private:
  /// Position, velocity, quaternion (w, x, y, z), body rates, thrusts of the motors.
  using State = std::array<double, 17>;
  Eigen::Vector3d vector(std::size_t at) const { return {state_[at], state_[at + 1], state_[at + 2]}; }

  State state_{};
  double drag_;
  Eigen::Vector4d commanded_;
};

}  // namespace tern_host

#endif
