// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/seen_world.hpp"

#include <algorithm>
#include <cmath>

namespace tern_host {
namespace {

/// Discs around a ball: it looks a little larger than it is.
void add_ball(const tern::Vec3& center, double radius, FlightWorld& world) {
  constexpr int kDiscs = 8;
  for (int k = 0; k < kDiscs; ++k) {
    const double low = radius * (2.0 * k / kDiscs - 1.0);
    const double high = radius * (2.0 * (k + 1) / kDiscs - 1.0);
    const double widest = low * high <= 0.0 ? 0.0 : std::min(std::abs(low), std::abs(high));
    const double across = std::sqrt(radius * radius - widest * widest);
    world.cylinders.push_back({center.x, center.y, center.z + low, center.z + high, across});
  }
}

void add_thing(const Thing& thing, const tern::Vec3& at, FlightWorld& world) {
  const tern::Vec3& h = thing.half;
  if (thing.shape == tern::TrackShape::kBall) return add_ball(at, thing.radius, world);
  if (thing.shape == tern::TrackShape::kCylinder) {
    world.cylinders.push_back({at.x, at.y, at.z - h.z, at.z + h.z, thing.radius});
  } else {
    world.blocks.push_back({{at.x - h.x, at.y - h.y, at.z - h.z}, {at.x + h.x, at.y + h.y, at.z + h.z}});
  }
}

}  // namespace

void SeenWorld::move_to(std::int64_t t) {
  if (!sees_things()) return;
  with_things_.blocks = truth_.blocks;
  with_things_.cylinders = truth_.cylinders;
  for (std::size_t k = 0; k < truth_.things.size(); ++k) add_thing(truth_.things[k], things_.place(k, t), with_things_);
}

}  // namespace tern_host
