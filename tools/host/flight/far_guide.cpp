// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/far_guide.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/fine_parts.hpp"
#include "host/number.hpp"

namespace tern_host {
namespace {

constexpr double kAhead = 0.45;  ///< of the window's shorter level side
constexpr int kWorkPart = 4;     ///< of what a tick of the flight may spend

double ahead_of(const FlightWorld& world) {
  return kAhead * std::min(world.settings.window.x, world.settings.window.y);
}

std::int32_t cells(double length, double cell) {
  return static_cast<std::int32_t>(std::min(std::ceil(length / cell - 1e-9), 1e6));
}

tern::GridSpec coarse_spec(const FlightWorld& world) {
  const double cell = world.settings.far_cell;
  const tern::Box& b = world.boundary;
  tern::GridSpec spec{};
  spec.origin = b.lower;
  spec.cell = cell;
  spec.dims = {cells(b.upper.x - b.lower.x, cell), cells(b.upper.y - b.lower.y, cell),
               cells(b.upper.z - b.lower.z, cell)};
  spec.boundary = b;
  return spec;
}

void mark_known(const FlightWorld& world, tern::Grid& fine) {
  for (std::size_t k = 0; k < world.blocks.size(); ++k) {
    const bool is_known = std::find(world.unmapped.begin(), world.unmapped.end(), k) == world.unmapped.end();
    if (is_known) fine.mark_box(world.blocks[k]);
  }
  for (const Cylinder& c : world.cylinders) fine.mark_cylinder({{c.x, c.y, c.bottom}, c.radius, c.top - c.bottom});
}

}  // namespace

void refuse_far_way(const FlightWorld& world, const Place& place) {
  const FlightSettings& s = world.settings;
  const bool has_more = !world.vias.empty() || world.landing.speed > 0.0 || s.goal_jitter.size > 0.0;
  if (s.far_cell > 0.0 && has_more) {
    throw RecordError(place, "far_cell is for worlds without vias, and without land and goal_jitter");
  }
  const double most = ahead_of(world) / tern::kLeastAhead;
  if (s.far_cell > most) {
    throw RecordError(place, "far_cell is " + brief(s.far_cell) + " m, and at most " + brief(most) +
                                 " m with this window; set a smaller far_cell or a wider window");
  }
}

FarGuide::FarGuide(const FlightWorld& world)
    : work_(static_cast<std::uint32_t>(world.settings.work_per_tick / kWorkPart)),
      memory_(new tern::Workspace),
      planner_(memory_.get(), sizeof *memory_) {
  const tern::GridSpec spec = coarse_spec(world);
  words_.resize(tern::grid_words(spec.dims));
  if (coarse_.bind(spec, words_.data(), words_.size()) != tern::Status::kOk) {
    throw std::runtime_error(world.name + ": a coarse grid of this boundary in cells of " +
                             brief(world.settings.far_cell) + " m has too many cells; set a larger far_cell");
  }
  mark_from_fine(coarse_, [&](tern::Grid& fine) { mark_known(world, fine); });
  far_.start({std::min(ahead_of(world), tern::kMostAhead * spec.cell)}, coarse_, planner_);
  far_.set_goal(world.goal);
}

bool FarGuide::tick(const tern::Vec3& position, const tern::FlightReport& report, const tern::RollingMap& map,
                    std::int64_t t) {
  return far_.tick(position, report, map, t, work_);
}

}  // namespace tern_host
