// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The true world's geometry.
#include "host/flight/flight_world.hpp"

#include <algorithm>
#include <cmath>

namespace tern_host {
namespace {

double distance_to(const tern::Box& b, const tern::Vec3& p) {
  const double x = std::max({b.lower.x - p.x, p.x - b.upper.x, 0.0});
  const double y = std::max({b.lower.y - p.y, p.y - b.upper.y, 0.0});
  const double z = std::max({b.lower.z - p.z, p.z - b.upper.z, 0.0});
  return std::sqrt(x * x + y * y + z * z);
}

double distance_to(const Cylinder& c, const tern::Vec3& p) {
  const double side = std::max(0.0, std::hypot(p.x - c.x, p.y - c.y) - c.radius);
  return std::hypot(side, std::max({c.bottom - p.z, p.z - c.top, 0.0}));
}

/// Where a line is between two planes: [enter, leave] cut down; false where nothing is left.
bool cut(double from, double along, double lower, double upper, double& enter, double& leave) {
  if (along < 0.0 || along > 0.0) {
    const double a = (lower - from) / along;
    const double b = (upper - from) / along;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
    return enter < leave;
  }
  return from >= lower && from <= upper;
}

double hit(const tern::Box& b, const tern::Vec3& from, const tern::Vec3& along, double most) {
  double enter = 0.0;
  double leave = most;
  const bool meets = cut(from.x, along.x, b.lower.x, b.upper.x, enter, leave) &&
                     cut(from.y, along.y, b.lower.y, b.upper.y, enter, leave) &&
                     cut(from.z, along.z, b.lower.z, b.upper.z, enter, leave);
  return meets ? enter : most;
}

double hit(const Cylinder& c, const tern::Vec3& from, const tern::Vec3& along, double most) {
  const double x = from.x - c.x;
  const double y = from.y - c.y;
  const double square = along.x * along.x + along.y * along.y;
  const double mixed = x * along.x + y * along.y;
  const double rest = mixed * mixed - square * (x * x + y * y - c.radius * c.radius);
  if (rest <= 0.0 || !(square > 0.0)) return most;
  double enter = (-mixed - std::sqrt(rest)) / square;
  double leave = (-mixed + std::sqrt(rest)) / square;
  enter = std::max(enter, 0.0);
  leave = std::min(leave, most);
  return enter < leave && cut(from.z, along.z, c.bottom, c.top, enter, leave) ? enter : most;
}

/// Where the line leaves the boundary.
double hit_walls(const tern::Box& b, const tern::Vec3& from, const tern::Vec3& along, double most) {
  double enter = 0.0;
  double leave = most;
  cut(from.x, along.x, b.lower.x, b.upper.x, enter, leave);
  cut(from.y, along.y, b.lower.y, b.upper.y, enter, leave);
  cut(from.z, along.z, b.lower.z, b.upper.z, enter, leave);
  return leave;
}

}  // namespace

double clearance(const FlightWorld& world, const tern::Vec3& p) {
  const tern::Box& b = world.boundary;
  double best =
      std::min({p.x - b.lower.x, b.upper.x - p.x, p.y - b.lower.y, b.upper.y - p.y, p.z - b.lower.z, b.upper.z - p.z});
  for (const tern::Box& block : world.blocks) best = std::min(best, distance_to(block, p));
  for (const Cylinder& cylinder : world.cylinders) best = std::min(best, distance_to(cylinder, p));
  return best;
}

double first_hit(const FlightWorld& world, const tern::Vec3& from, const tern::Vec3& along, double most) {
  double best = hit_walls(world.boundary, from, along, most);
  for (const tern::Box& block : world.blocks) best = std::min(best, hit(block, from, along, best));
  for (const Cylinder& cylinder : world.cylinders) best = std::min(best, hit(cylinder, from, along, best));
  return best;
}

}  // namespace tern_host
