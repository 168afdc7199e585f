// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/vehicle/rate_loop.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "host/vehicle/rigid_body.hpp"
#include "host/yaw/yaw_units.hpp"

namespace tern_host {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// What a full output accelerates the body with, rad/s^2. The stacks' outputs have no unit; this is the body that their
/// gains fit.
const Vector3d kFullOutput(130.0, 130.0, 25.0);

}  // namespace

double new_part(double cutoff, double dt) {
  return dt / (dt + 1.0 / (kTurn * cutoff));
}

Vector3d within(const Vector3d& v, const Vector3d& most) {
  return v.cwiseMax(-most).cwiseMin(most);
}

Vector2d no_longer(const Vector2d& v, double most) {
  const double length = v.norm();
  return length > most ? Vector2d(v * (most / length)) : v;
}

Eigen::Quaterniond attitude_of(const Vector3d& up, double yaw) {
  const Vector3d left = up.cross(Vector3d(std::cos(yaw), std::sin(yaw), 0.0)).normalized();
  Eigen::Matrix3d r;
  r << left.cross(up), left, up;
  return Eigen::Quaterniond(r);
}

Vector3d RateLoop::torque(const Vector3d& wanted, const Vector3d& rates, double dt) {
  const Vector3d change = (rates - last_rates_) / dt;
  angular_ += new_part(gains_.d_cutoff, dt) * (change - angular_);
  last_rates_ = rates;
  target_ += (gains_.target_cutoff > 0.0 ? new_part(gains_.target_cutoff, dt) : 1.0) * (wanted - target_);
  const Vector3d off = target_ - rates;
  const Vector3d output = gains_.p.cwiseProduct(off) + integral_ - gains_.d.cwiseProduct(angular_);
  integral_ = within(integral_ + dt * gains_.i.cwiseProduct(off), gains_.most_integral);
  return Body::inertia().cwiseProduct(within(output, Vector3d::Ones()).cwiseProduct(kFullOutput));
}

}  // namespace tern_host
