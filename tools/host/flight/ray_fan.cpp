// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/ray_fan.hpp"

#include <algorithm>
#include <cmath>

namespace tern_host {
namespace {

/// Where a line is between two planes: [enter, leave] cut down.
void cut(double from, double along, double lower, double upper, double& enter, double& leave) {
  if (along < 0.0 || along > 0.0) {
    const double a = (lower - from) / along;
    const double b = (upper - from) / along;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  } else if (from < lower || from > upper) {
    leave = enter;
  }
}

/// A half-plane, and how far its rays reach.
struct Plane {
  tern::Vec3 eye;
  double x, y, far;
};

void add_slab(const tern::Box& b, const Plane& plane, std::vector<Slab>& slabs) {
  Slab slab{0.0, plane.far, b.lower.z, b.upper.z};
  cut(plane.eye.x, plane.x, b.lower.x, b.upper.x, slab.enter, slab.leave);
  cut(plane.eye.y, plane.y, b.lower.y, b.upper.y, slab.enter, slab.leave);
  if (slab.enter < slab.leave) slabs.push_back(slab);
}

void add_slab(const Cylinder& c, const Plane& plane, std::vector<Slab>& slabs) {
  const double from_x = plane.eye.x - c.x;
  const double from_y = plane.eye.y - c.y;
  const double square = plane.x * plane.x + plane.y * plane.y;
  const double mixed = from_x * plane.x + from_y * plane.y;
  const double rest = mixed * mixed - square * (from_x * from_x + from_y * from_y - c.radius * c.radius);
  if (rest <= 0.0) return;
  const double enter = std::max(0.0, (-mixed - std::sqrt(rest)) / square);
  const double leave = std::min(plane.far, (-mixed + std::sqrt(rest)) / square);
  if (enter < leave) slabs.push_back({enter, leave, c.bottom, c.top});
}

}  // namespace

FlightWorld nearby(const FlightWorld& world, const tern::Vec3& eye, double reach) {
  FlightWorld near;
  near.boundary = world.boundary;
  for (const tern::Box& b : world.blocks) {
    const double x = std::max({b.lower.x - eye.x, eye.x - b.upper.x, 0.0});
    const double y = std::max({b.lower.y - eye.y, eye.y - b.upper.y, 0.0});
    if (x * x + y * y < reach * reach) near.blocks.push_back(b);
  }
  for (const Cylinder& c : world.cylinders) {
    const double x = c.x - eye.x;
    const double y = c.y - eye.y;
    const double most = reach + c.radius;
    if (x * x + y * y < most * most) near.cylinders.push_back(c);
  }
  return near;
}

RayFan::RayFan(const FlightWorld& near, const tern::Vec3& eye, double far, double x, double y)
    : height_(eye.z), room_{0.0, 0.0, 0.0, 0.0} {
  const Plane plane{eye, x, y, far};
  add_slab(near.boundary, plane, slabs_);
  if (!slabs_.empty()) room_ = slabs_.front();
  slabs_.clear();
  for (const tern::Box& block : near.blocks) add_slab(block, plane, slabs_);
  for (const Cylinder& cylinder : near.cylinders) add_slab(cylinder, plane, slabs_);
  std::sort(slabs_.begin(), slabs_.end(), [](const Slab& a, const Slab& b) { return a.enter < b.enter; });
}

double RayFan::distance(double down) const {
  double best = room_.leave;
  double enter = 0.0;
  cut(height_, -down, room_.bottom, room_.top, enter, best);
  for (const Slab& slab : slabs_) {
    if (slab.enter >= best) break;
    double from = slab.enter;
    double to = slab.leave;
    cut(height_, -down, slab.bottom, slab.top, from, to);
    if (from < to) best = std::min(best, from);
  }
  return best;
}

}  // namespace tern_host
