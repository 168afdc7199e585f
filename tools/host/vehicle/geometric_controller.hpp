// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_VEHICLE_GEOMETRIC_CONTROLLER_HPP
#define TERN_HOST_VEHICLE_GEOMETRIC_CONTROLLER_HPP

#include "host/vehicle/controller.hpp"

namespace tern_host {

/// Geometric tracking control on SE(3) (Lee, Leok and McClamroch, CDC 2010), but with separate errors of the thrust
/// direction and the heading (Brescianini and D'Andrea, Tilt-Prioritized Quadrocopter Attitude Control, 2018). Thrust
/// direction, body rates and angular acceleration come from the flat state of the commanded motion; it is read one
/// motor's lag ahead, and drag is made up for.
class GeometricController : public Controller {
 public:
  Wrench control(const Believed& state, double t, double step, const Setpoints& setpoints) override;
};

}  // namespace tern_host

#endif
