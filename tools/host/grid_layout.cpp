// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/grid_layout.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "host/number.hpp"

namespace tern_host {
namespace {

using tern::Vec3;

bool below(const Vec3& a, const Vec3& b) {
  return a.x < b.x || a.y < b.y || a.z < b.z;
}

bool block_sticks_out(const Scenario& scenario) {
  return std::any_of(scenario.blocks.begin(), scenario.blocks.end(), [&](const Block& block) {
    return below(block.box.lower, scenario.boundary.lower) || below(scenario.boundary.upper, block.box.upper);
  });
}

[[noreturn]] void throw_too_large(const Scenario& scenario, const std::string& reason) {
  const bool default_resolution = scenario.resolution_place.file.empty();
  throw ScenarioError(default_resolution ? scenario.boundary_place : scenario.resolution_place,
                      "a grid of " + brief(scenario.resolution) + " m voxels over the boundary " + reason);
}

/// Voxels that cover an extent, at least one; kLatticeTolerance lets a multiple of the resolution be one.
std::int32_t cells(const Scenario& scenario, double extent, double padding) {
  const double exact_count = std::ceil(extent / scenario.resolution - tern::kLatticeTolerance) + 2.0 * padding;
  if (!(exact_count <= tern::kMaxDimension)) {
    throw_too_large(scenario, "has more than " + std::to_string(tern::kMaxDimension) +
                                  " voxels along an axis (TERN_MAX_DIMENSION)");
  }
  return std::max(1, static_cast<std::int32_t>(exact_count));
}

}  // namespace

tern::GridSpec lay_out_grid(const Scenario& scenario) {
  const Vec3& lower = scenario.boundary.lower;
  const Vec3& upper = scenario.boundary.upper;
  const double cell = scenario.resolution;
  const double padding = block_sticks_out(scenario) ? std::ceil(scenario.radius / cell) + 1.0 : 0.0;
  tern::GridSpec spec{};
  spec.dims = {cells(scenario, upper.x - lower.x, padding), cells(scenario, upper.y - lower.y, padding),
               cells(scenario, upper.z - lower.z, padding)};
  if (tern::grid_words(spec.dims) == 0) {
    throw_too_large(scenario, "has more than " + std::to_string(tern::kMaxCells) + " voxels (TERN_MAX_CELLS)");
  }
  spec.origin = {lower.x - padding * cell, lower.y - padding * cell, lower.z - padding * cell};
  spec.cell = cell;
  spec.boundary = scenario.boundary;
  spec.radius = scenario.radius;
  return spec;
}

}  // namespace tern_host
