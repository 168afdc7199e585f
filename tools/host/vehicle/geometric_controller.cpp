// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/vehicle/geometric_controller.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "tern/flatness.hpp"

namespace tern_host {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Gains a mass and a moment of inertia: natural frequencies of about 8 and 22 rad/s, of yaw 4.5, damped.
constexpr double kPosition = 64.0;
constexpr double kVelocity = 12.8;
const Vector3d kAttitude(500.0, 500.0, 20.0);
const Vector3d kRates(36.0, 36.0, 8.0);
constexpr double kAhead = 1e-3;  // seconds, of the difference quotient

tern::FlatState flat(const Setpoint& setpoint, const Vector3d& acceleration) {
  tern::Sample sample = setpoint.sample;
  sample.acceleration = {acceleration.x(), acceleration.y(), acceleration.z()};
  return tern::flat_state(sample, {std::cos(setpoint.yaw), std::sin(setpoint.yaw), setpoint.yaw_rate});
}

Matrix3d rotation(const tern::FlatState& state) {
  Matrix3d r;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) r(row, column) = state.attitude[row][column];
  }
  return r;
}

/// What a motion accelerates its vehicle with, drag included.
Vector3d effort(const Setpoint& setpoint) {
  const tern::Vec3& v = setpoint.sample.velocity;
  return to_eigen(setpoint.sample.acceleration) + Body::kDrag * Vector3d(v.x, v.y, 0.0);
}

/// How fast the thrust's direction turns, about the body's x and y.
Vector3d tilting(const tern::FlatState& state) {
  return {state.body_rates.x, state.body_rates.y, 0.0};
}

/// The rates to follow. About the thrust, that is only the turn that the heading asks for: near free fall, keeping the
/// nose level as the thrust swings would take faster turns than the motors can give.
Vector3d rates_of(const tern::FlatState& state, const Setpoint& setpoint) {
  return tilting(state) + Vector3d(0.0, 0.0, setpoint.yaw_rate * state.attitude[2][2]);
}

/// How far the body is turned beyond its target, about its own axes: twice the sine of half the angle, of the thrust's
/// tilt and of the heading each for itself. `back` is the target's attitude in the body's frame. Near free fall, a
/// motion asks for faster turns about the thrust than the motors can give; the thrust then keeps its direction, and the
/// heading lags.
Vector3d turned_beyond(const Matrix3d& back) {
  const Eigen::Quaterniond whole(back);
  const Eigen::Quaterniond heading = Eigen::Quaterniond(whole.w(), 0.0, 0.0, whole.z()).normalized();
  const Eigen::Quaterniond tilt = whole * heading.conjugate();
  return -2.0 * Vector3d(tilt.x(), tilt.y(), whole.w() < 0.0 ? -heading.z() : heading.z());
}

}  // namespace

Wrench GeometricController::control(const Believed& state, double t, double, const Setpoints& setpoints) {
  const Setpoint now = setpoints(t);
  const Setpoint soon = setpoints(t + Body::kMotorLag);
  const Setpoint later = setpoints(t + Body::kMotorLag + kAhead);
  const Vector3d wanted = effort(soon) - kPosition * (state.position - to_eigen(now.sample.position)) -
                          kVelocity * (state.velocity - to_eigen(now.sample.velocity));
  const Matrix3d r = state.attitude.toRotationMatrix();
  const tern::FlatState target = flat(soon, wanted);
  const Matrix3d back = r.transpose() * rotation(target);
  const Vector3d turned = turned_beyond(back);
  const Vector3d planned = tilting(flat(soon, effort(soon)));
  const Vector3d spin_up = (tilting(flat(later, effort(later))) - planned) / kAhead;
  const Vector3d rates_off = state.body_rates - back * rates_of(target, soon);
  const Vector3d angular = back * spin_up - kAttitude.cwiseProduct(turned) - kRates.cwiseProduct(rates_off);
  const Vector3d inertia = Body::inertia();
  const Vector3d gyroscopic = state.body_rates.cross(Vector3d(inertia.cwiseProduct(state.body_rates)));
  const double thrust = Body::kMass * (wanted + Vector3d(0.0, 0.0, tern::kGravity)).dot(r.col(2));
  return {thrust, inertia.cwiseProduct(angular) + gyroscopic};
}

}  // namespace tern_host
