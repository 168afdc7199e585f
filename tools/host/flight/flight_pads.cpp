// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/flight_pads.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "host/number.hpp"
#include "host/text_records.hpp"

namespace tern_host {
namespace {

using tern::Vec3;

constexpr double kTouch = 1e-9;  // metres

/// True if a thing that is as high as this, and whose nearest point is so far from the column's axis, is in the column.
bool is_in(const tern::Cylinder& column, double bottom, double top, double aside) {
  return top > column.base.z + kTouch && bottom < column.base.z + column.height - kTouch &&
         aside < column.radius - kTouch;
}

double aside(const tern::Box& b, const Vec3& from) {
  return std::hypot(std::clamp(from.x, b.lower.x, b.upper.x) - from.x,
                    std::clamp(from.y, b.lower.y, b.upper.y) - from.y);
}

}  // namespace

std::vector<Pad> pads_of(const FlightWorld& world) {
  std::vector<Pad> pads;
  if (world.column.radius > 0.0) pads.push_back({world.start, world.column.base.z});
  if (world.landing.speed > 0.0) pads.push_back({world.goal, world.landing.ground});
  return pads;
}

const Pad* pad_below(const std::vector<Pad>& pads, const Vec3& point, double most) {
  for (const Pad& pad : pads) {
    if (std::hypot(point.x - pad.place.x, point.y - pad.place.y) <= most) return &pad;
  }
  return nullptr;
}

double clearance_of_flight(const FlightWorld& world, const Vec3& p, double most) {
  const std::vector<Pad> pads = pads_of(world);
  const Pad* const pad = pad_below(pads, p, most);
  if (pad == nullptr) return clearance(world, p);
  FlightWorld above;
  above.boundary = world.boundary;
  if (world.boundary.lower.z <= pad->ground) above.boundary.lower.z = std::min(p.z, world.boundary.lower.z) - 1e9;
  for (const tern::Box& block : world.blocks) {
    if (block.upper.z > pad->ground) above.blocks.push_back(block);
  }
  for (const Cylinder& cylinder : world.cylinders) {
    if (cylinder.top > pad->ground) above.cylinders.push_back(cylinder);
  }
  return clearance(above, p);
}

void refuse_untrue_ground(const FlightWorld& world) {
  const tern::Cylinder& column = world.column;
  if (!(column.radius > 0.0)) return;
  const auto refuse = [&](const std::string& what) { throw RecordError(world.places.column, "column: " + what); };
  const tern::Box& b = world.boundary;
  if (column.base.z < b.lower.z - kTouch) refuse("the ground is higher, at " + brief(b.lower.z));
  const double wall = std::min(std::min(column.base.x - b.lower.x, b.upper.x - column.base.x),
                               std::min(column.base.y - b.lower.y, b.upper.y - column.base.y));
  if (wall < column.radius - kTouch || column.base.z + column.height > b.upper.z + kTouch) {
    refuse("it is not within the boundary");
  }
  for (const tern::Box& block : world.blocks) {
    if (is_in(column, block.lower.z, block.upper.z, aside(block, column.base))) {
      refuse("a block is in it, " + brief(aside(block, column.base)) + " m from its axis and up to " +
             brief(block.upper.z) + " m high");
    }
  }
  for (const Cylinder& c : world.cylinders) {
    const double off = std::max(0.0, std::hypot(c.x - column.base.x, c.y - column.base.y) - c.radius);
    if (is_in(column, c.bottom, c.top, off)) refuse("a cylinder is in it, " + brief(off) + " m from its axis");
  }
}

}  // namespace tern_host
