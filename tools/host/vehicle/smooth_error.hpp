// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_VEHICLE_SMOOTH_ERROR_HPP
#define TERN_HOST_VEHICLE_SMOOTH_ERROR_HPP

#include <cmath>

#include "host/flight/noise.hpp"
#include "host/yaw/yaw_units.hpp"
#include "tern/vec3.hpp"

namespace tern_host {

/// A vector that wanders smoothly and is never longer than its bound: a sine of its own on each axis.
class SmoothError {
 public:
  SmoothError(double bound, Noise& noise) : size_(bound / std::sqrt(3.0)) {
    for (Wave& wave : waves_) wave = {noise.within(0.5, 3.0), noise.within(0.0, kTurn)};
  }
  tern::Vec3 at(double t) const { return {waves_[0].at(t) * size_, waves_[1].at(t) * size_, waves_[2].at(t) * size_}; }
  tern::Vec3 rate_at(double t) const {
    return {waves_[0].rate_at(t) * size_, waves_[1].rate_at(t) * size_, waves_[2].rate_at(t) * size_};
  }

 private:
  struct Wave {
    double rate;
    double phase;
    double at(double t) const { return std::sin(rate * t + phase); }
    double rate_at(double t) const { return rate * std::cos(rate * t + phase); }
  };
  double size_;
  Wave waves_[3]{};
};

}  // namespace tern_host

#endif
