// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_VEHICLE_AIR_HPP
#define TERN_HOST_VEHICLE_AIR_HPP

namespace tern_host {

/// The air that a rigid body flies in.
struct Air {
  double wind = 0.0;       ///< mean speed, m/s
  bool has_angle = false;  ///< whether `angle` is given; otherwise the seed decides
  double angle = 0.0;      ///< where it blows to, rad from x
  bool has_gusts = false;  ///< whether `gusts` is given; otherwise a third of the mean
  double gusts = 0.0;      ///< standard deviation of the horizontal gusts, m/s; upright half of it
  double drag = 0.1;       ///< level deceleration for each m/s through the air, 1/s

  double deviation() const { return has_gusts ? gusts : wind / 3.0; }
};

}  // namespace tern_host

#endif
