// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_VEHICLE_GEOMETRIC_CONTROLLER_HPP
#define TERN_HOST_VEHICLE_GEOMETRIC_CONTROLLER_HPP

#include "host/vehicle/rigid_body.hpp"
#include "host/vehicle/vehicle.hpp"

namespace tern_host {

/// What a controller believes about its body. World frame; body rates in the body's.
struct Believed {
  Eigen::Vector3d position;
  Eigen::Vector3d velocity;
  Eigen::Quaterniond attitude;
  Eigen::Vector3d body_rates;
};

/// Geometric tracking control on SE(3) (Lee, Leok and McClamroch, CDC 2010), but with separate errors of the thrust
/// direction and the heading (Brescianini and D'Andrea, Tilt-Prioritized Quadrocopter Attitude Control, 2018). Thrust
/// direction, body rates and angular acceleration come from the flat state of the commanded motion; it is read one
/// motor's lag ahead, and drag is made up for.
Wrench geometric_control(const Believed& state, double t, const Setpoints& setpoints);

}  // namespace tern_host

#endif
