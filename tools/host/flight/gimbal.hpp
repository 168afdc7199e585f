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

/// Turns a camera to where the flight looks, as fast as it may: about the vertical, and up and down as far as its mount
/// lets it. Angles in rad.
class Gimbal {
 public:
  Gimbal() = default;
  Gimbal(double yaw, const FlightSettings& settings)
      : yaw_(yaw),
        low_(settings.mount.gimbal_low),
        high_(settings.mount.gimbal_high),
        pitch_(std::clamp(0.0, low_, high_)),
        most_(settings.yaw_rate),
        hz_(settings.tick_hz) {}

  double yaw() const { return yaw_; }
  double rate() const { return rate_; }
  double pitch() const { return pitch_; }  ///< up from where the mount holds it

  /// Chooses how fast to turn until the next tick.
  void turn_to(const tern::Command& command) {
    constexpr double kLeastLook = 0.4;  // metres: nearer points say nothing about where to look
    const double x = command.look_at.x - command.sample.position.x;
    const double y = command.look_at.y - command.sample.position.y;
    const double z = command.look_at.z - command.sample.position.z;
    rate_ = pitch_rate_ = 0.0;
    const double flat = std::hypot(x, y);
    if (std::hypot(flat, z) >= kLeastLook) {
      const double wanted = std::clamp(std::atan2(z, flat), low_, high_);
      pitch_rate_ = std::clamp((wanted - pitch_) * hz_, -most_, most_);
    }
    if (flat < kLeastLook) return;
    rate_ = std::clamp(std::remainder(std::atan2(y, x) - yaw_, kTurn) * hz_, -most_, most_);
  }
  /// To the next tick.
  void move_on() {
    yaw_ += rate_ / hz_;
    pitch_ += pitch_rate_ / hz_;
  }

 private:
  double yaw_ = 0.0;
  double rate_ = 0.0;
  double low_ = 0.0;
  double high_ = 0.0;
  double pitch_ = 0.0;
  double pitch_rate_ = 0.0;
  double most_ = 0.0;
  double hz_ = 1.0;
};

}  // namespace tern_host

#endif
