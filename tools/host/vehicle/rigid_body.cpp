// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/vehicle/rigid_body.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <cmath>

#include "tern/flatness.hpp"

namespace tern_host {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

/// From the motors' thrusts (front left, front right, rear right, rear left) to thrust and torque.
Eigen::Matrix4d mixer() {
  const double l = Body::kArm;
  const double c = Body::kTorqueOfThrust;
  Eigen::Matrix4d m;
  m << 1.0, 1.0, 1.0, 1.0,  //
      l, -l, -l, l,         //
      -l, -l, l, l,         //
      c, -c, c, -c;
  return m;
}

const Eigen::Matrix4d& unmixer() {
  static const Eigen::Matrix4d inverse = mixer().inverse();
  return inverse;
}

constexpr double kMostThrust = Body::kThrustToWeight * Body::kMass * tern::kGravity / 4.0;  // of a motor

}  // namespace

RigidBody::RigidBody(const Vector3d& position, const Vector3d& velocity, double yaw, double drag) : drag_(drag) {
  const double each = Body::kMass * tern::kGravity / 4.0;
  state_ = {position.x(),
            position.y(),
            position.z(),
            velocity.x(),
            velocity.y(),
            velocity.z(),
            std::cos(0.5 * yaw),
            0.0,
            0.0,
            std::sin(0.5 * yaw),
            0.0,
            0.0,
            0.0,
            each,
            each,
            each,
            each};
  commanded_.setConstant(each);
}

/// Yaw gives way where a motor is at its limit: it takes much thrust for little torque.
void RigidBody::command(const Wrench& wrench) {
  const Vector4d level = unmixer() * Vector4d(wrench.thrust, wrench.torque.x(), wrench.torque.y(), 0.0);
  const Vector4d base = level.cwiseMax(0.0).cwiseMin(kMostThrust);
  const Vector4d yaw = unmixer() * Vector4d(0.0, 0.0, 0.0, wrench.torque.z());
  double part = 1.0;
  for (Eigen::Index k = 0; k < 4; ++k) {
    const double room = yaw[k] > 0.0 ? kMostThrust - base[k] : base[k];
    if (std::abs(yaw[k]) > room) part = std::min(part, room / std::abs(yaw[k]));
  }
  commanded_ = base + part * yaw;
}

void RigidBody::advance(double step, const Vector3d& wind) {
  static const Eigen::Matrix4d mix = mixer();
  const auto flow = [&](const State& x, State& rate, double) {
    const Vector3d velocity(x[3], x[4], x[5]);
    const Eigen::Quaterniond attitude(x[6], x[7], x[8], x[9]);
    const Vector3d rates(x[10], x[11], x[12]);
    const Vector4d forces = mix * Vector4d(x[13], x[14], x[15], x[16]);
    const Vector3d air = velocity - wind;
    const Vector3d acceleration = attitude.normalized() * Vector3d(0.0, 0.0, forces[0] / Body::kMass) -
                                  Vector3d(0.0, 0.0, tern::kGravity) - drag_ * Vector3d(air.x(), air.y(), 0.0);
    const Eigen::Quaterniond turn = attitude * Eigen::Quaterniond(0.0, rates.x(), rates.y(), rates.z());
    const Vector3d inertia = Body::inertia();
    const Vector3d spin = rates.cross(Vector3d(inertia.cwiseProduct(rates)));
    const Vector3d angular = (forces.tail<3>() - spin).cwiseQuotient(inertia);
    rate = {x[3],           x[4],           x[5],           acceleration.x(), acceleration.y(), acceleration.z(),
            0.5 * turn.w(), 0.5 * turn.x(), 0.5 * turn.y(), 0.5 * turn.z(),   angular.x(),      angular.y(),
            angular.z()};
    for (std::size_t k = 0; k < 4; ++k) {
      rate[13 + k] = (commanded_[static_cast<Eigen::Index>(k)] - x[13 + k]) / Body::kMotorLag;
    }
  };
  boost::numeric::odeint::runge_kutta4<State> stepper;
  stepper.do_step(flow, state_, 0.0, step);
  const double norm = Eigen::Vector4d(state_[6], state_[7], state_[8], state_[9]).norm();
  for (std::size_t k = 6; k < 10; ++k) state_[k] /= norm;
}

}  // namespace tern_host
