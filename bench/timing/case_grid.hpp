// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_TIMING_CASE_GRID_HPP
#define TERN_BENCH_TIMING_CASE_GRID_HPP

#include <cstdint>

#include "timing/cases.hpp"

namespace tern_timing {

/// Voxels that cover an extent, both in metres.
inline std::int32_t cells(double extent, double resolution) {
  const double exact = extent / resolution - tern::kLatticeTolerance;
  const auto whole = static_cast<std::int32_t>(exact);
  return static_cast<double>(whole) < exact ? whole + 1 : whole;
}

/// The grid that a case asks for: from the boundary's lower corner, as many voxels as cover the boundary.
inline tern::GridSpec spec_of(const Case& input) {
  const tern::Vec3& lower = input.boundary.lower;
  const tern::Vec3& upper = input.boundary.upper;
  tern::GridSpec spec{};
  spec.origin = lower;
  spec.cell = input.resolution;
  spec.dims = {cells(upper.x - lower.x, spec.cell), cells(upper.y - lower.y, spec.cell),
               cells(upper.z - lower.z, spec.cell)};
  spec.boundary = input.boundary;
  spec.radius = input.radius;
  return spec;
}

}  // namespace tern_timing

#endif
