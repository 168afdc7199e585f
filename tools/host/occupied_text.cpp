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

/// True where a block's voxels are as near to the point as the status says of some obstacle.
bool is_block(const PlanResult& result, const Vec3& point) {
  const Vec3& o = result.grid.origin;
  const double cell = result.grid.cell;
  const double enough = result.report.raw_occupied ? 1e-9 : result.grid.clearance();
  return std::any_of(result.scenario.blocks.begin(), result.scenario.blocks.end(), [&](const Block& block) {
    const tern::Box& box = block.box;
    const double x = gap(point.x, box.lower.x, box.upper.x, o.x, cell);
    const double y = gap(point.y, box.lower.y, box.upper.y, o.y, cell);
    const double z = gap(point.z, box.lower.z, box.upper.z, o.z, cell);
    return std::sqrt(x * x + y * y + z * z) < enough;
  });
}

std::string occupied_text(const PlanResult& result) {
  const bool inside = result.report.raw_occupied;
  const bool takes_unknown = result.scenario.unknown == Unknown::kSolid && !result.scenario.known.empty();
  if (takes_unknown && !is_block(result, point_of(result))) {
    return std::string(inside ? "; it is in" : "; it is too close to") +
           " space that the map does not know, which `unknown solid` takes for obstacles: choose a point in known "
           "space, "
           "or set `unknown free`";
  }
  return inside ? "; it is inside an obstacle" : "; it is outside of obstacles, but too close to one";
}

std::string narrow_text(const tern::Report& report) {
  const std::string cause = report.fence != tern::kNoFence ? "a fence leaves no whole voxel near it"
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
      return narrow_text(result.report);
    default:
      return "";
  }
}

}  // namespace tern_host
