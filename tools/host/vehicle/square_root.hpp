// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// ArduPilot's way from an error to a correction: proportional near 0, and beyond that no faster than the correction's
// own rate of change can end.
#ifndef TERN_HOST_VEHICLE_SQUARE_ROOT_HPP
#define TERN_HOST_VEHICLE_SQUARE_ROOT_HPP

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace tern_host {

/// The correction for an error. `gain`, 1/s; `most_change`: of the correction, a second. No more than what ends the
/// error within `dt` seconds.
inline double square_root(double error, double gain, double most_change, double dt) {
  const double linear = most_change / (gain * gain);
  const double size = std::fabs(error);
  const double correction = size <= linear ? gain * size : std::sqrt(2.0 * most_change * (size - 0.5 * linear));
  return std::copysign(std::min(correction, size / dt), error);
}

inline Eigen::Vector2d square_root(const Eigen::Vector2d& error, double gain, double most_change, double dt) {
  const double size = error.norm();
  if (!(size > 0.0)) return Eigen::Vector2d::Zero();
  return error * (square_root(size, gain, most_change, dt) / size);
}

/// The error of which the correction is `correction`, 0 or more.
inline double square_root_error(double correction, double gain, double most_change) {
  if (correction <= most_change / gain) return correction / gain;
  return 0.5 * most_change / (gain * gain) + 0.5 * correction * correction / most_change;
}

}  // namespace tern_host

#endif
