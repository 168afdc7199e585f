// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_GIMBAL_HPP
#define TERN_HOST_FLIGHT_GIMBAL_HPP

#include <algorithm>
#include <cmath>

#include "host/flight/flight_world.hpp"
#include "host/yaw/yaw_units.hpp"
#include "tern/flight.hpp"

namespace tern_host {

/// Turns a camera about the vertical to where the flight looks, as fast as it may. Angles in rad.
class Gimbal {
 public:
  Gimbal() = default;
  Gimbal(double yaw, const FlightSettings& settings) : yaw_(yaw), most_(settings.yaw_rate), hz_(settings.tick_hz) {}

  double yaw() const { return yaw_; }
  double rate() const { return rate_; }

  /// Chooses how fast to turn until the next tick.
  void turn_to(const tern::Command& command) {
    constexpr double kLeastLook = 0.4;  // metres: nearer points say nothing about where to look
    const double x = command.look_at.x - command.sample.position.x;
    const double y = command.look_at.y - command.sample.position.y;
    rate_ = 0.0;
    if (std::hypot(x, y) < kLeastLook) return;
    rate_ = std::clamp(std::remainder(std::atan2(y, x) - yaw_, kTurn) * hz_, -most_, most_);
  }
  /// To the next tick.
  void move_on() { yaw_ += rate_ / hz_; }

 private:
  double yaw_ = 0.0;
  double rate_ = 0.0;
  double most_ = 0.0;
  double hz_ = 1.0;
};

}  // namespace tern_host

#endif
