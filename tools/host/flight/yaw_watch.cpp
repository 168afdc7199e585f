// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/yaw_watch.hpp"

#include <cmath>

#include "host/nanoseconds.hpp"
#include "host/number.hpp"

namespace tern_host {
namespace {

constexpr double kSlack = 1e-9;  // rad, rad/s and rad/s^2: rounding

}  // namespace

void YawWatch::look(std::int64_t t) {
  check(t);
  check(t + tick_ / 2);
}

/// Between two instants, the rate changes by what the limits allow in that time, and the angle by its mean but for what
/// they allow. Times are counted in nanoseconds: a tick, or half of one, may not be a whole number of them.
void YawWatch::check(std::int64_t t) {
  const tern::YawSample now = yaw_(t);
  const double step = seconds_of(t - last_time_);
  const double most = settings_.yaw_acceleration;
  const bool within =
      std::abs(now.yaw.rate) <= settings_.yaw_rate + kSlack && std::abs(now.acceleration) <= most + kSlack;
  const double turned = now.angle - last_angle_;
  const double mean = 0.5 * (now.yaw.rate + last_rate_);
  const double changed = std::abs(now.yaw.rate - last_rate_);
  const bool smooth = !has_last_ || (std::abs(turned) <= settings_.yaw_rate * step + kSlack &&
                                     std::abs(turned - mean * step) <= 0.25 * most * step * step + kSlack &&
                                     changed <= most * step + kSlack);
  if (broken_.empty() && !(within && smooth)) {
    broken_ = std::string("yaw: ") + (within ? "a step" : "beyond its limits") + " at t = " + fixed(seconds_of(t), 3);
  }
  has_last_ = true;
  last_time_ = t;
  last_angle_ = now.angle;
  last_rate_ = now.yaw.rate;
}

}  // namespace tern_host
