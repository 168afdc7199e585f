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

/// Relative rounding error of a stored world coordinate, 2^-52: at most one unit in the last place.
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

/// Cells by which a world coordinate of this size may miss the lattice plane that it stands for. The sum of the
/// lattice's own tolerance and the rounding error of the stored number, which is the larger part at 1e9 m.
inline double world_tolerance(const GridSpec& spec, double world) {
  return kLatticeTolerance + absolute(world) * kWorldRounding / spec.cell;
}

/// A face's local coordinate: moved onto the lattice plane that its world coordinate stands for, if there is one.
inline double onto_lattice(const GridSpec& spec, double local, int a) {
  const double cells = local / spec.cell;
  const std::int32_t nearest = floor_index(cells + 0.5, 0, axis(spec.dims, a));
  const double plane = nearest * spec.cell;
  return absolute(cells - nearest) <= world_tolerance(spec, axis(spec.origin, a) + plane) ? plane : local;
}

/// World coordinates must resolve this share of a cell. If they do not, "inside" has no meaning there.
constexpr double kOriginResolution = 1e-3;

inline bool resolves_cells(double world, double cell) {
  return absolute(world) * kWorldRounding <= kOriginResolution * cell;
}

/// True if no lower face lies beyond the opposite upper face.
inline bool valid_box(const Box& box) {
  return box.lower.x <= box.upper.x && box.lower.y <= box.upper.y && box.lower.z <= box.upper.z;
}

/// The voxels on one axis whose interior meets [lower, upper]; empty if that lies outside the grid.
inline IndexRange voxels_met(const GridSpec& spec, double lower, double upper, int a) {
  const std::int32_t count = axis(spec.dims, a);
  const double origin = axis(spec.origin, a);
  const double from = (lower - origin) / spec.cell + world_tolerance(spec, lower);
  const double to = (upper - origin) / spec.cell - world_tolerance(spec, upper);
  // Keeps one index beyond either end, to tell a plate on the grid's upper face from a plate past it.
  std::int32_t begin = floor_index(from, -1, count + 1);
  std::int32_t end = ceil_index(to, -1, count + 1);
  if (end <= begin) {  // a plate on a lattice plane: it meets no interior, and must not be lost
    if (begin == count) begin = count - 1;
    end = begin + 1;
  }
  return {begin < 0 ? 0 : begin, end > count ? count : end};
}

/// Metres by which a state of a plan may lie beyond the boundary: the tolerance of the trajectory stage. The next plan
/// may begin there.
constexpr double kFaceTolerance = 1e-9;

/// The rounding errors of a face's coordinate, of a point's coordinate, and of the corridor between them, in units in
/// the last place. kFaceUlps counts units of the face's coordinate, kFaceExtentUlps units of the grid's size.
constexpr double kFaceUlps = 4.0;
constexpr double kFaceExtentUlps = 12.0;

/// Moves a local coordinate that rounding left outside the boundary onto the face; returns any other as it is. Moving a
/// face onto the lattice changed it by up to kLatticeTolerance of a cell. The point may miss the face by as much.
inline double onto_boundary(const Grid& grid, double local, int a) {
  const GridSpec& spec = grid.spec();
  const Box boundary = grid.local_boundary();
  const double lower = axis(boundary.lower, a);
  const double upper = axis(boundary.upper, a);
  const Vec3 size{spec.dims.x * spec.cell, spec.dims.y * spec.cell, spec.dims.z * spec.cell};
  const auto rounding = [&](const Vec3& face) {
    const double ulps = kFaceUlps * absolute(axis(face, a)) + kFaceExtentUlps * ((size.x + size.y) + size.z);
    return kFaceTolerance * larger(1.0, spec.cell) + 2.0 * kLatticeTolerance * spec.cell + kWorldRounding * ulps;
  };
  if (local < lower && local >= lower - rounding(spec.boundary.lower)) return lower;
  if (local > upper && local <= upper + rounding(spec.boundary.upper)) return upper;
  return local;
}

/// The closed cube of a voxel, local frame.
inline Box cube_of(const Grid& grid, const Voxel& voxel) {
  const double cell = grid.spec().cell;
  return {{voxel.x * cell, voxel.y * cell, voxel.z * cell},
          {(voxel.x + 1) * cell, (voxel.y + 1) * cell, (voxel.z + 1) * cell}};
}

/// The point of a free voxel that paths lead through: its centre or, if the centre is outside a thin boundary, the
/// nearest point inside.
inline Vec3 free_point(const Grid& grid, const Voxel& voxel) {
  const Box boundary = grid.local_boundary();
  Vec3 point = grid.center(voxel);
  for (int a = 0; a < 3; ++a) {
    axis(point, a) = clamp(axis(point, a), axis(boundary.lower, a), axis(boundary.upper, a));
  }
  return point;
}

/// Voxels whose cube lies inside the boundary on one axis; empty (begin >= end) if there are none.
inline IndexRange whole_inside(const Grid& grid, int a) {
  const GridSpec& spec = grid.spec();
  const Box boundary = grid.local_boundary();
  const std::int32_t count = axis(spec.dims, a);
  return {ceil_index(axis(boundary.lower, a) / spec.cell - kLatticeTolerance, 0, count),
          floor_index(axis(boundary.upper, a) / spec.cell + kLatticeTolerance, 0, count)};
}

/// True if the boundary holds no whole voxel on this axis. The boundary is then narrower than two voxels.
inline bool is_thin(const Grid& grid, int a) {
  const Box boundary = grid.local_boundary();
  if (axis(boundary.upper, a) - axis(boundary.lower, a) >= 2.0 * grid.spec().cell) return false;
  const IndexRange whole = whole_inside(grid, a);
  return whole.begin >= whole.end;
}

/// Layers of voxels that count as inside the boundary on one axis; at least one. These are the layers that lie inside
/// it or, on a thin axis, the one or two that it meets. A flat boundary on a lattice plane meets the layers on both
/// sides.
inline IndexRange inside_boundary(const Grid& grid, int a) {
  if (!is_thin(grid, a)) return whole_inside(grid, a);
  const GridSpec& spec = grid.spec();
  const Box boundary = grid.local_boundary();
  const std::int32_t count = axis(spec.dims, a);
  const IndexRange met{floor_index(axis(boundary.lower, a) / spec.cell + kLatticeTolerance, 0, count),
                       ceil_index(axis(boundary.upper, a) / spec.cell - kLatticeTolerance, 0, count)};
  return met.begin < met.end ? met : overlap({0, count}, {met.end - 1, met.end + 1});
}

}  // namespace tern

#endif
