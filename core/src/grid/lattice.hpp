// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From metres to voxel indices: every rounding decision of the grid stage is made here.
#ifndef TERN_GRID_LATTICE_HPP
#define TERN_GRID_LATTICE_HPP

#include <cstdint>

#include "base/math.hpp"
#include "grid/bit_rows.hpp"
#include "tern/grid.hpp"

namespace tern {

/// Relative rounding of a stored world coordinate, 2^-52: one unit in the last place at most.
constexpr double kWorldRounding = 1.0 / 4503599627370496.0;

inline std::int32_t axis(const Voxel& v, int a) {
  return a == 0 ? v.x : (a == 1 ? v.y : v.z);
}
inline std::int32_t& axis(Voxel& v, int a) {
  return a == 0 ? v.x : (a == 1 ? v.y : v.z);
}

/// Largest integer <= x, clamped to [lo, hi] before the conversion; lo for NaN.
inline std::int32_t floor_index(double x, std::int32_t lo, std::int32_t hi) {
  if (!(x > static_cast<double>(lo))) return lo;
  if (x >= static_cast<double>(hi)) return hi;
  const std::int32_t whole = static_cast<std::int32_t>(x);
  return static_cast<double>(whole) > x ? whole - 1 : whole;
}

/// Smallest integer >= x, clamped to [lo, hi].
inline std::int32_t ceil_index(double x, std::int32_t lo, std::int32_t hi) {
  return -floor_index(-x, -hi, -lo);
}

/// Cells by which a world coordinate of this size may miss the lattice plane that it means: the lattice's own
/// tolerance and the rounding of the stored number, which at 1e9 m outweighs it.
inline double world_tolerance(const GridSpec& spec, double world) {
  return kLatticeTolerance + absolute(world) * kWorldRounding / spec.cell;
}

/// Metres by which a state of a plan may lie beyond the boundary (the trajectory stage's tolerance), and the next plan
/// begin there.
constexpr double kFaceTolerance = 1e-9;

/// A local coordinate that rounding left outside the boundary, put on the face; any other as it is. The face was put
/// on the lattice by up to a tolerance of its size, and the point may miss the face by as much.
inline double onto_boundary(const Grid& grid, double local, int a) {
  const GridSpec& spec = grid.spec();
  const Box boundary = grid.local_boundary();
  const double lower = axis(boundary.lower, a);
  const double upper = axis(boundary.upper, a);
  const auto rounding = [&](const Vec3& face) {
    return 2.0 * world_tolerance(spec, axis(face, a)) * spec.cell + kFaceTolerance;
  };
  if (local < lower && local >= lower - rounding(spec.boundary.lower)) return lower;
  if (local > upper && local <= upper + rounding(spec.boundary.upper)) return upper;
  return local;
}

/// Voxels whose cube lies inside the boundary on one axis; empty (begin >= end) where none does.
inline IndexRange inside_boundary(const Grid& grid, int a) {
  const GridSpec& spec = grid.spec();
  const Box boundary = grid.local_boundary();
  const std::int32_t count = axis(spec.dims, a);
  return {ceil_index(axis(boundary.lower, a) / spec.cell - kLatticeTolerance, 0, count),
          floor_index(axis(boundary.upper, a) / spec.cell + kLatticeTolerance, 0, count)};
}

}  // namespace tern

#endif
