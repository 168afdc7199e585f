// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_CONTACT_SEARCH_HPP
#define TERN_HOST_FLIGHT_CONTACT_SEARCH_HPP

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "host/flight/flight_world.hpp"
#include "host/vehicle/vehicle.hpp"

namespace tern_host {

/// The most that a body accelerates, m/s^2: by a thrust of four times the weight, gravity and drag, or as it is told
/// to.
inline double most_acceleration(const FlightSettings& settings) {
  return std::max(60.0, 2.0 * settings.a_max);
}

/// Looks for contacts between two ticks: from where the body is, it cannot touch anything before it has flown as far as
/// its clearance leaves room, at its speed and the most that it accelerates. Where there is less room than a millimetre
/// it is looked at once a millimetre, so that a contact is missed only if it is less than a micrometre deep.
class ContactSearch {
 public:
  ContactSearch(const FlightSettings& settings, const Vehicle& vehicle, double clearance)
      : body_(settings.body_radius), most_(most_acceleration(settings)) {
    at(vehicle, clearance);
  }

  /// Where the body is now.
  void at(const Vehicle& vehicle, double clearance) {
    const tern::Vec3 v = vehicle.velocity();
    speed_ = std::hypot(v.x, std::hypot(v.y, v.z));
    way_ = std::max(kLeastWay, clearance - body_);
  }
  /// When to look again, nanoseconds: at `end` at the latest.
  std::int64_t next(std::int64_t t, std::int64_t end) const {
    const double time = (std::sqrt(speed_ * speed_ + 2.0 * most_ * way_) - speed_) / most_;
    return std::min(end, t + std::max(kLeastTime, static_cast<std::int64_t>(1e9 * time)));
  }

 private:
  static constexpr double kLeastWay = 1e-3;
  static constexpr std::int64_t kLeastTime = 20000;  // nanoseconds: a millimetre at 50 m/s

  double body_;
  double most_;
  double speed_ = 0.0;
  double way_ = 0.0;
};

}  // namespace tern_host

#endif
