// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_VEHICLE_CONTROLLER_HPP
#define TERN_HOST_VEHICLE_CONTROLLER_HPP

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

/// What flies a rigid body.
class Controller {
 public:
  virtual ~Controller() = default;
  /// One step of `step` seconds at time t, seconds; slower loops run when their time has come.
  virtual Wrench control(const Believed& state, double t, double step, const Setpoints& setpoints) = 0;
};

}  // namespace tern_host

#endif
