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

/// Keep-outs may have no end anywhere.
bool block_sticks_out(const Scenario& scenario) {
  return !scenario.marked.empty() ||
         std::any_of(scenario.blocks.begin(), scenario.blocks.end(), [&](const Block& block) {
           return below(block.box.lower, scenario.boundary.lower) || below(scenario.boundary.upper, block.box.upper);
         });
}

/// The grid of a scenario at one resolution. Counts are doubles: they may be beyond any integer.
struct Layout {
  double cell;
  double padding;  ///< voxels on every side
  Vec3 counts;

  bool within_dimension() const { return std::max({counts.x, counts.y, counts.z}) <= tern::kMaxDimension; }
  tern::Voxel dims() const {
    return {static_cast<std::int32_t>(counts.x), static_cast<std::int32_t>(counts.y),
            static_cast<std::int32_t>(counts.z)};
  }
  bool fits() const { return within_dimension() && tern::grid_words(dims()) != 0; }
};

/// Voxels that cover an extent, at least one; kLatticeTolerance lets a multiple of the resolution be one.
double cells(double extent, double cell, double padding) {
  return std::max(1.0, std::ceil(extent / cell - tern::kLatticeTolerance) + 2.0 * padding);
}

Layout layout_at(const Scenario& scenario, double cell, bool padded) {
  const Vec3& lower = scenario.boundary.lower;
  const Vec3& upper = scenario.boundary.upper;
  const Vec3 extent = {upper.x - lower.x, upper.y - lower.y, upper.z - lower.z};
  const double padding = padded ? std::ceil(scenario.clearance() / cell) + 1.0 : 0.0;
  return {
      cell, padding, {cells(extent.x, cell, padding), cells(extent.y, cell, padding), cells(extent.z, cell, padding)}};
}

/// About the finest resolution that fits, rounded up to two digits; 0 where none does. The one asked for, which does
/// not fit, is doubled until it does, and the interval between the last two is halved.
double resolution_that_fits(const Scenario& scenario, bool padded) {
  const auto fits = [&](double cell) { return layout_at(scenario, cell, padded).fits(); };
  double fine = scenario.resolution;
  double coarse = 2.0 * fine;
  while (coarse <= tern::kMaxCell && !fits(coarse)) {
    fine = coarse;
    coarse *= 2.0;
  }
  for (int i = 0; i < 20; ++i) {
    const double middle = 0.5 * (fine + coarse);
    (fits(middle) ? coarse : fine) = middle;
  }
  const double digit = std::pow(10.0, std::floor(std::log10(coarse)) - 1.0);
  const double rounded = std::ceil(coarse / digit) * digit;
  return rounded <= tern::kMaxCell && fits(rounded) ? rounded : 0.0;
}

[[noreturn]] void throw_too_large(const Scenario& scenario, const Layout& layout) {
  const bool default_resolution = scenario.resolution_place.file.empty();
  std::string reason = "a grid of " + brief(scenario.resolution) + " m voxels over the boundary has more than ";
  reason += layout.within_dimension()
                ? std::to_string(tern::kMaxCells) + " voxels (TERN_MAX_CELLS)"
                : std::to_string(tern::kMaxDimension) + " voxels along an axis (TERN_MAX_DIMENSION)";
  const double fitting = resolution_that_fits(scenario, layout.padding > 0.0);
  if (fitting > 0.0) reason += "; a resolution of " + brief(fitting) + " fits";
  throw ScenarioError(default_resolution ? scenario.boundary_place : scenario.resolution_place, reason);
}

}  // namespace

tern::GridSpec lay_out_grid(const Scenario& scenario) {
  const bool padded = scenario.unknown == Unknown::kSolid || block_sticks_out(scenario);
  const Layout layout = layout_at(scenario, scenario.resolution, padded);
  if (!layout.fits()) throw_too_large(scenario, layout);
  const Vec3& lower = scenario.boundary.lower;
  const double margin = layout.padding * layout.cell;
  tern::GridSpec spec{};
  spec.dims = layout.dims();
  spec.origin = {lower.x - margin, lower.y - margin, lower.z - margin};
  spec.cell = layout.cell;
  spec.boundary = scenario.boundary;
  spec.radius = scenario.radius;
  spec.tracking_margin = scenario.tracking_margin;
  return spec;
}

}  // namespace tern_host
