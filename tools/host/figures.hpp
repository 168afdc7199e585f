// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a plan amounts to, measured by dense sampling on the host: nothing here trusts the core's own check.
#ifndef TERN_HOST_FIGURES_HPP
#define TERN_HOST_FIGURES_HPP

#include "host/scenario.hpp"
#include "tern/trajectory.hpp"

namespace tern_host {

/// How far a vector goes along each axis, both ways, and horizontally.
struct PeakRange {
  tern::Vec3 least{};       ///< 0 where an axis is never negative
  tern::Vec3 most{};        ///< 0 where an axis is never positive
  double horizontal = 0.0;  ///< highest norm of (x, y)
};

struct Figures {
  double duration = 0.0;      ///< s
  double length = 0.0;        ///< of the trajectory, m
  double snap = 0.0;          ///< integral of |snap|^2, m^2/s^7
  double speed = 0.0;         ///< highest |v|, m/s
  double acceleration = 0.0;  ///< highest |a|, m/s^2
  tern::Vec3 v_peak{};        ///< highest |v| an axis, m/s
  tern::Vec3 a_peak{};        ///< highest |a| an axis, m/s^2
  PeakRange v_range;          ///< m/s
  PeakRange a_range;          ///< m/s^2
  PeakRange j_range;          ///< m/s^3
  double v_use = 0.0;         ///< highest part of a velocity limit that is used, 1 where it is reached
  double a_use = 0.0;         ///< likewise of an acceleration limit
  double j_use = 0.0;         ///< and of a jerk limit
  double thrust_least = 0.0;  ///< of the thrust, m/s^2
  double thrust_most = 0.0;   ///< m/s^2
  double tilt = 0.0;          ///< largest, rad
  double rate = 0.0;          ///< largest body rate across the thrust, rad/s
  double clearance = 0.0;     ///< smallest distance to a block as written in the scenario, m; infinite with none
};

/// Samples every millisecond of the trajectory, as long as that is at most two million samples.
Figures measure(const tern::Trajectory& trajectory, const Scenario& scenario);

/// Euclidean distance of a point to the nearest block of the scenario, m; infinite where there is none.
double distance_to_blocks(const tern::Vec3& point, const Scenario& scenario);

}  // namespace tern_host

#endif
