// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/family_scenario.hpp"

#include <algorithm>
#include <cmath>

#include "host/flight/full_knowledge.hpp"
#include "host/flight/world_family.hpp"
#include "host/number.hpp"
#include "tern/flight.hpp"

namespace tern_host {
namespace {

std::string record(const char* name, const std::vector<double>& values) {
  std::string line = name;
  for (const double value : values) line += " " + exact(value);
  return line + "\n";
}

std::string vector_record(const char* name, const tern::Vec3& v) {
  return record(name, {v.x, v.y, v.z});
}

std::string block_record(const tern::Box& b) {
  return record("block", {b.lower.x, b.lower.y, b.lower.z, b.upper.x, b.upper.y, b.upper.z});
}

/// Strips along x that cover the cylinder.
std::string covering_blocks(const Cylinder& c, double width) {
  const int strips = std::max(1, static_cast<int>(std::ceil(2.0 * c.radius / width)));
  const double step = 2.0 * c.radius / strips;
  std::string text;
  for (int k = 0; k < strips; ++k) {
    const double low = -c.radius + step * k;
    const double high = low + step;
    const double nearest = low <= 0.0 && high >= 0.0 ? 0.0 : std::min(std::abs(low), std::abs(high));
    const double half = std::sqrt(c.radius * c.radius - nearest * nearest);
    text += block_record({{c.x - half, c.y + low, c.bottom}, {c.x + half, c.y + high, c.top}});
  }
  return text;
}

/// The faces of the world are walls; those of a scenario bound the robot's centre.
std::string boundary_record(const FlightWorld& world) {
  const tern::Box& b = world.boundary;
  const double r = radius_of(world.settings);
  return record("boundary", {b.lower.x + r, b.lower.y + r, b.lower.z + r, b.upper.x - r, b.upper.y - r, b.upper.z - r});
}

}  // namespace

std::string scenario_text(const FlightWorld& world) {
  const tern::Limits limits = limits_of(world.settings);
  std::string text = "# " + world.name + " with full knowledge\n" + boundary_record(world);
  for (const tern::Box& block : world.blocks) text += block_record(block);
  for (const Cylinder& cylinder : world.cylinders) text += covering_blocks(cylinder, world.settings.cell);
  text += vector_record("start", world.start) + vector_record("goal", world.goal);
  for (const tern::Via& via : world.vias) {
    text += "via " + exact(via.position.x) + " " + exact(via.position.y) + " " + exact(via.position.z) + " " +
            exact(via.tolerance) + (via.stop ? " stop\n" : "\n");
  }
  text += record("resolution", {world.settings.cell}) + record("radius", {radius_of(world.settings)});
  text += vector_record("v_max", limits.v_max) + vector_record("a_max", limits.a_max);
  text += record("v_horizontal", {limits.v_horizontal}) + record("a_horizontal", {limits.a_horizontal});
  if (world.settings.j_max > 0.0) text += vector_record("j_max", limits.j_max);
  if (limits.thrust_max > 0.0) text += record("thrust_max", {limits.thrust_max});
  if (limits.thrust_min > 0.0) text += record("thrust_min", {limits.thrust_min});
  if (limits.tilt_tangent > 0.0) text += record("tilt_tangent", {limits.tilt_tangent});
  if (limits.rate_max > 0.0) text += record("rate_max", {limits.rate_max});
  return text + record("time_weight", {tern::flight_spec(limits).time_weight});
}

Scenario named_scenario(const std::string& name, const std::vector<std::string>& overrides, Ends ends) {
  FamilyMember member;
  if (!is_member(name, member)) return read_scenario(name, overrides, ends);
  return parse_scenario(scenario_text(read_flight_world(name, {})), name, overrides, ends);
}

}  // namespace tern_host
