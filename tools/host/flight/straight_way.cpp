// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/straight_way.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "host/flight/full_knowledge.hpp"

namespace tern_host {
namespace {

/// A straight line, and how fast it may be flown.
struct Leg {
  double length, speed, acceleration;

  Leg(const tern::Vec3& a, const tern::Vec3& b, const tern::Limits& limits) {
    const double level = std::hypot(b.x - a.x, b.y - a.y);
    const double upright = std::abs(b.z - a.z);
    length = std::hypot(level, upright);
    const auto most = [&](double along, double up) { return length / std::max(level / along, upright / up); };
    speed = length > 0.0 ? most(limits.v_horizontal, limits.v_max.z) : limits.v_horizontal;
    acceleration = length > 0.0 ? most(limits.a_horizontal, limits.a_max.z) : limits.a_horizontal;
  }
  /// What it takes to come to the speed, beyond the same way at the speed.
  double delay() const { return 0.5 * speed / acceleration; }
};

}  // namespace

double straight_time(const FlightWorld& world) {
  const tern::Limits limits = limits_of(world.settings);
  tern::Vec3 from = world.start;
  std::vector<Leg> legs;
  double time = 0.0;
  for (const tern::Via& point : mission_of(world)) {
    legs.emplace_back(from, point.position, limits);
    time += legs.back().length / legs.back().speed;
    from = point.position;
  }
  const Leg& only = legs.front();
  const bool reaches_speed = only.length >= only.speed * only.speed / only.acceleration;
  if (legs.size() == 1 && !reaches_speed) return 2.0 * std::sqrt(only.length / only.acceleration);
  return time + legs.front().delay() + legs.back().delay();
}

}  // namespace tern_host
