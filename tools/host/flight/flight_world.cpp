// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The true world's geometry.
#include "host/flight/flight_world.hpp"

#include <algorithm>
#include <cmath>

namespace tern_host {

double distance_to(const tern::Box& b, const tern::Vec3& p) {
  const double x = std::max({b.lower.x - p.x, p.x - b.upper.x, 0.0});
  const double y = std::max({b.lower.y - p.y, p.y - b.upper.y, 0.0});
  const double z = std::max({b.lower.z - p.z, p.z - b.upper.z, 0.0});
  return std::sqrt(x * x + y * y + z * z);
}

double distance_to(const Cylinder& c, const tern::Vec3& p) {
  // No std::hypot: its care for tiny and huge numbers would take a seventh of a flight's time here.
  const double x = p.x - c.x;
  const double y = p.y - c.y;
  const double side = std::max(0.0, std::sqrt(x * x + y * y) - c.radius);
  const double above = std::max({c.bottom - p.z, p.z - c.top, 0.0});
  return std::sqrt(side * side + above * above);
}

double distance_to(const Appearance& appearance, const tern::Vec3& p) {
  return appearance.is_block ? distance_to(appearance.block, p) : distance_to(appearance.cylinder, p);
}

std::vector<tern::Via> mission_of(const FlightWorld& world) {
  std::vector<tern::Via> mission = world.vias;
  mission.emplace_back();
  mission.back().position = world.goal;
  return mission;
}

FlightWorld with_appeared(FlightWorld world, const std::vector<Appearance>& appeared) {
  for (const Appearance& a : appeared) {
    if (a.is_block) {
      world.blocks.push_back(a.block);
    } else {
      world.cylinders.push_back(a.cylinder);
    }
  }
  return world;
}

double room_within(const tern::Box& b, const tern::Vec3& p) {
  return std::min(
      {p.x - b.lower.x, b.upper.x - p.x, p.y - b.lower.y, b.upper.y - p.y, p.z - b.lower.z, b.upper.z - p.z});
}

double clearance(const FlightWorld& world, const tern::Vec3& p) {
  double best = room_within(world.boundary, p);
  for (const tern::Box& block : world.blocks) best = std::min(best, distance_to(block, p));
  for (const Cylinder& cylinder : world.cylinders) best = std::min(best, distance_to(cylinder, p));
  return best;
}

}  // namespace tern_host
