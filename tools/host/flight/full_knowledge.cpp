// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/full_knowledge.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "host/vehicle/vehicle.hpp"
#include "tern/flight.hpp"
#include "tern/planner.hpp"

namespace tern_host {
namespace {

constexpr double kSlowest = 2.0;   ///< m/s and
constexpr double kGentlest = 6.0;  ///< m/s^2 up and down at most
/// The same down for rigid bodies: near free fall, the thrust is small, and its direction would have to turn faster
/// than the motors can turn the body.
constexpr double kGentlestFall = 3.0;

tern::GridSpec spec_of(const FlightWorld& world) {
  const tern::Box& b = world.boundary;
  const double cell = world.settings.cell;
  const double radius = radius_of(world.settings);
  const auto count = [cell](double low, double high) {
    return static_cast<int>(std::ceil((high - low) / cell - 1e-9));
  };
  tern::GridSpec spec{};
  spec.origin = b.lower;
  spec.cell = cell;
  spec.dims = {count(b.lower.x, b.upper.x), count(b.lower.y, b.upper.y), count(b.lower.z, b.upper.z)};
  // The faces are walls.
  spec.boundary = {{b.lower.x + radius, b.lower.y + radius, b.lower.z + radius},
                   {b.upper.x - radius, b.upper.y - radius, b.upper.z - radius}};
  spec.radius = radius;
  return spec;
}

}  // namespace

double radius_of(const FlightSettings& settings) {
  return settings.body_radius + settings.pose_margin + settings.tracking_margin;
}

tern::Limits limits_of(const FlightSettings& s) {
  tern::Limits limits{{s.v_max, s.v_max, std::min(s.v_max, kSlowest)},
                      {s.a_max, s.a_max, std::min(s.a_max, kGentlest)}};
  if (is_rigid_body(s.tracking)) limits.a_min.z = -std::min(s.a_max, kGentlestFall);
  limits.v_horizontal = s.v_max;
  limits.a_horizontal = s.a_max;
  limits.j_max = {s.j_max, s.j_max, s.j_max};
  limits.thrust_max = s.thrust_max;
  limits.thrust_min = s.thrust_min;
  limits.tilt_tangent = s.tilt_tangent;
  limits.rate_max = s.rate_max;
  return limits;
}

double full_knowledge_time(const FlightWorld& world) {
  const tern::GridSpec spec = spec_of(world);
  std::vector<std::uint64_t> words(tern::grid_words(spec.dims));
  tern::Grid grid;
  if (words.empty() || grid.bind(spec, words.data(), words.size()) != tern::Status::kOk) return 0.0;
  for (const tern::Box& block : world.blocks) grid.mark_box(block);
  for (const Cylinder& c : world.cylinders) grid.mark_cylinder({{c.x, c.y, c.bottom}, c.radius, c.top - c.bottom});
  grid.inflate();
  const auto memory = std::make_unique<tern::Workspace>();
  tern::Planner planner(memory.get(), sizeof *memory);
  const std::vector<tern::Fence> fences = fences_of(world.fences);
  tern::Request request{};
  request.fences = fences.data();
  request.fence_count = static_cast<std::int32_t>(fences.size());
  request.start.position = world.start;
  request.goal.position = world.goal;
  request.vias = world.vias.data();
  request.via_count = static_cast<std::int32_t>(world.vias.size());
  request.limits = limits_of(world.settings);
  request.time_weight = tern::flight_spec(request.limits).time_weight;
  const auto plan = std::make_unique<tern::Trajectory>();
  tern::Report report;
  return planner.plan(grid, request, *plan, report) == tern::Status::kOk ? tern::duration(*plan) : 0.0;
}

}  // namespace tern_host
