// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/occupied_text.hpp"

#include <algorithm>
#include <cmath>

#include "host/number.hpp"

namespace tern_host {
namespace {

using tern::Status;
using tern::Vec3;

/// The point that the status is about.
Vec3 point_of(const PlanResult& result) {
  const tern::Report& report = result.report;
  if (report.via != tern::kNoVia) return result.scenario.vias[static_cast<std::size_t>(report.via)].position;
  const bool at_start = report.status == Status::kStartOccupied || report.status == Status::kStartTooNarrow;
  return at_start ? result.scenario.start.position : result.scenario.goal.position;
}

/// How far a coordinate is from the voxels that an interval meets; 0 inside.
double gap(double at, double lower, double upper, double origin, double cell) {
  const double first = origin + cell * std::floor((lower - origin) / cell + tern::kLatticeTolerance);
  const double last = origin + cell * std::ceil((upper - origin) / cell - tern::kLatticeTolerance);
  return std::max({0.0, first - at, at - last});
}

/// The block whose voxels are nearest to a point.
struct NearestBlock {
  const Block* block = nullptr;
  double of_voxels = 0.0;  ///< their distance, metres
};

NearestBlock nearest_block(const PlanResult& result, const Vec3& point) {
  const Vec3& o = result.grid.origin;
  const double cell = result.grid.cell;
  NearestBlock nearest;
  for (const Block& block : result.scenario.blocks) {
    const tern::Box& box = block.box;
    const double x = gap(point.x, box.lower.x, box.upper.x, o.x, cell);
    const double y = gap(point.y, box.lower.y, box.upper.y, o.y, cell);
    const double z = gap(point.z, box.lower.z, box.upper.z, o.z, cell);
    const double apart = std::sqrt(x * x + y * y + z * z);
    if (nearest.block == nullptr || apart < nearest.of_voxels) nearest = {&block, apart};
  }
  return nearest;
}

/// "a block", or the name of a keepout.
std::string name_of(const Block& block, const Scenario& scenario) {
  if (!block.keepout) return "a block";
  const auto index = std::count_if(scenario.blocks.data(), &block, [](const Block& before) { return before.keepout; });
  return scenario.keepouts[static_cast<std::size_t>(index)];
}

std::string near_text(const PlanResult& result, const Vec3& point, const NearestBlock& nearest) {
  const tern::Box& box = nearest.block->box;
  const Vec3 at{std::clamp(point.x, box.lower.x, box.upper.x), std::clamp(point.y, box.lower.y, box.upper.y),
                std::clamp(point.z, box.lower.z, box.upper.z)};
  const double apart = std::hypot(at.x - point.x, at.y - point.y, at.z - point.z);
  const Scenario& s = result.scenario;
  std::string text = "; it is too close to " + name_of(*nearest.block, s) + ", " + fixed(apart, 3) + " m away at (" +
                     brief(at.x) + ", " + brief(at.y) + ", " + brief(at.z) + ")";
  if (apart >= s.clearance()) {
    text += ", whose voxels of " + brief(s.resolution) + " m are " + fixed(nearest.of_voxels, 3) + " m away";
  }
  text += "; all of it must be " + brief(s.clearance()) + " m away: radius " + brief(s.radius);
  return s.tracking_margin > 0.0 ? text + " and tracking_margin " + brief(s.tracking_margin) : text;
}

std::string occupied_text(const PlanResult& result) {
  const bool inside = result.report.raw_occupied;
  const Vec3 point = point_of(result);
  const NearestBlock nearest = nearest_block(result, point);
  const double enough = inside ? 1e-9 : result.grid.clearance();
  const bool is_block = nearest.block != nullptr && nearest.of_voxels < enough;
  const bool takes_unknown = result.scenario.unknown == Unknown::kSolid && !result.scenario.known.empty();
  if (takes_unknown && !is_block) {
    return std::string(inside ? "; it is in" : "; it is too close to") +
           " space that the map does not know, which `unknown solid` takes for obstacles: choose a point in known "
           "space, "
           "or set `unknown free`";
  }
  if (inside && is_block && nearest.block->keepout) return "; it is inside " + name_of(*nearest.block, result.scenario);
  if (inside) return "; it is inside an obstacle";
  return is_block ? near_text(result, point, nearest) : "; it is outside of obstacles, but too close to one";
}

std::string narrow_text(const PlanResult& result) {
  const tern::Report& report = result.report;
  const std::string fence = "a fence" + zone_text(result.scenario.fences, report.fence);
  const std::string cause = report.fence != tern::kNoFence ? fence + " leaves no whole voxel near it"
                                                           : "obstacles and the boundary leave no whole voxel near it";
  if (!(report.finer_cell > 0.0)) {
    return "; " + cause + ", at no resolution that fits: choose another point, or a smaller radius";
  }
  return "; " + cause + ": a resolution of " + brief(report.finer_cell) + " m does";
}

}  // namespace

std::string describe_occupied(const PlanResult& result) {
  switch (result.report.status) {
    case Status::kStartOccupied:
    case Status::kGoalOccupied:
    case Status::kViaOccupied:
      return occupied_text(result);
    case Status::kStartTooNarrow:
    case Status::kGoalTooNarrow:
    case Status::kViaTooNarrow:
      return narrow_text(result);
    default:
      return "";
  }
}

}  // namespace tern_host
