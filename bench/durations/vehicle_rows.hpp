// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Limits of thrust, tilt and body rates as they are, at sampled instants: no polyhedron, no hull.
#ifndef TERN_BENCH_VEHICLE_ROWS_HPP
#define TERN_BENCH_VEHICLE_ROWS_HPP

#include <array>
#include <vector>

#include "base/bounds.hpp"
#include "curve/hermite.hpp"

namespace tern_bench {

/// Normalised derivatives of a segment's two ends on three axes, then theta: its time is e^theta.
using Local = std::array<double, 6 * tern::kJointOrder + 1>;

enum class VehicleRowKind { kMost, kLeast, kTilt, kRate };

/// A limit at one instant of a segment; at most 0 where it is kept.
struct VehicleRow {
  VehicleRowKind kind;
  int segment;
  int instant;  ///< of the segment
};

/// The rows of limits that exist, for so many segments.
std::vector<VehicleRow> vehicle_rows(const tern::MotionLimits& limits, int segments);

/// The row's value; `tau` is the unit of time. Fills the gradient unless it is null.
double vehicle_value(const VehicleRow& row, const tern::MotionLimits& limits, double tau, const Local& x,
                     Local* gradient);

}  // namespace tern_bench

#endif
