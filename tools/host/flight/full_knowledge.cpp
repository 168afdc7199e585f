// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/full_knowledge.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "tern/flight.hpp"
#include "tern/planner.hpp"

namespace tern_host {
namespace {

constexpr double kSlowest = 2.0;   ///< m/s and
constexpr double kGentlest = 6.0;  ///< m/s^2 up and down at most

/// The least distance of a point from a square.
double distance_to_square(double x, double y, double left, double lower, double side) {
  return std::hypot(std::max({left - x, x - left - side, 0.0}), std::max({lower - y, y - lower - side, 0.0}));
}

/// Marks every column of voxels that an upright cylinder touches.
void mark(const Cylinder& c, tern::Grid& grid) {
  const tern::GridSpec& spec = grid.spec();
  const auto first = [&](double low, double origin) {
    return std::max(0, static_cast<int>((low - origin) / spec.cell));
  };
  const int last_x = std::min(spec.dims.x - 1, static_cast<int>((c.x + c.radius - spec.origin.x) / spec.cell));
  const int last_y = std::min(spec.dims.y - 1, static_cast<int>((c.y + c.radius - spec.origin.y) / spec.cell));
  const int last_z = std::min(spec.dims.z - 1, static_cast<int>((c.top - spec.origin.z) / spec.cell));
  for (int y = first(c.y - c.radius, spec.origin.y); y <= last_y; ++y) {
    for (int x = first(c.x - c.radius, spec.origin.x); x <= last_x; ++x) {
      const double left = spec.origin.x + spec.cell * x;
      const double lower = spec.origin.y + spec.cell * y;
      if (distance_to_square(c.x, c.y, left, lower, spec.cell) >= c.radius) continue;
      for (int z = first(c.bottom, spec.origin.z); z <= last_z; ++z) grid.mark_voxel({x, y, z});
    }
  }
}

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
  return settings.body_radius + settings.tracking_margin + settings.pose_margin;
}

tern::Limits limits_of(const FlightSettings& s) {
  tern::Limits limits{{s.v_max, s.v_max, std::min(s.v_max, kSlowest)},
                      {s.a_max, s.a_max, std::min(s.a_max, kGentlest)}};
  limits.v_horizontal = s.v_max;
  limits.a_horizontal = s.a_max;
  limits.j_max = {s.j_max, s.j_max, s.j_max};
  return limits;
}

double full_knowledge_time(const FlightWorld& world) {
  const tern::GridSpec spec = spec_of(world);
  std::vector<std::uint64_t> words(tern::grid_words(spec.dims));
  tern::Grid grid;
  if (words.empty() || grid.bind(spec, words.data(), words.size()) != tern::Status::kOk) return 0.0;
  for (const tern::Box& block : world.blocks) grid.mark_box(block);
  for (const Cylinder& cylinder : world.cylinders) mark(cylinder, grid);
  grid.inflate();
  const auto memory = std::make_unique<tern::Workspace>();
  tern::Planner planner(memory.get(), sizeof *memory);
  tern::Request request{};
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
