// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "prove/grants.hpp"

#include "base/math.hpp"
#include "tern/proof.hpp"

namespace tern {
namespace {

double size_of(const Vec3& v) {
  return (absolute(v.x) + absolute(v.y)) + absolute(v.z);
}

double extent_of(const Grid& grid) {
  const GridSpec& spec = grid.spec();
  return size_of({spec.dims.x * spec.cell, spec.dims.y * spec.cell, spec.dims.z * spec.cell});
}

double grid_rounding(const Grid& grid) {
  return kUlp * (kGridUlps * extent_of(grid) + kOriginUlps * size_of(grid.spec().origin));
}

/// 2^k 7! / (7 - k)! / duration^k.
double amplification(double duration, int order) {
  double factor = 1.0;
  for (int k = 0; k < order; ++k) factor *= 2.0 * (kDegree - k) / duration;
  return factor;
}

}  // namespace

double check_distance(const Grid& grid) noexcept {
  return kCheckDistance * larger(1.0, grid.spec().cell);
}

double lattice_rounding(const Grid& grid) noexcept {
  return 2.0 * kLatticeTolerance * grid.spec().cell;
}

double place_rounding(const Grid& grid, const Trajectory& trajectory) noexcept {
  const double world = size_of(trajectory.origin) + size_of(grid.spec().origin);
  return grid_rounding(grid) + kOriginUlps * kUlp * world;
}

double face_grant(const Grid& grid, double face) noexcept {
  const double rounding = kUlp * (kFaceRoundingUlps * absolute(face) + kGridUlps * extent_of(grid));
  return check_distance(grid) + lattice_rounding(grid) + rounding;
}

double curve_distance(const Grid& grid, const Trajectory& trajectory) noexcept {
  const GridSpec& spec = grid.spec();
  const double size = (size_of(spec.origin) + size_of(trajectory.origin)) + extent_of(grid);
  return kProofTolerance * larger(1.0, spec.cell) + kPlaceUlps * kUlp * size;
}

Grant grant_to_plan(const Grid& grid, const Trajectory& trajectory) noexcept {
  const GridSpec& spec = grid.spec();
  const double rounding = place_rounding(grid, trajectory) + grid_rounding(grid) + kCornerUlps * kUlp * extent_of(grid);
  Box boundary{spec.boundary.lower - spec.origin, spec.boundary.upper - spec.origin};
  for (int a = 0; a < 3; ++a) {
    axis(boundary.lower, a) -= face_grant(grid, axis(spec.boundary.lower, a));
    axis(boundary.upper, a) += face_grant(grid, axis(spec.boundary.upper, a));
  }
  const double distance = check_distance(grid);
  return {2.0 * distance + lattice_rounding(grid) + rounding, distance + rounding, boundary, kCheckRelative, false};
}

Grant grant_to_curve(const Grid& grid, const Trajectory& trajectory) noexcept {
  const double distance = curve_distance(grid, trajectory);
  const Vec3 around{distance, distance, distance};
  const Box boundary = grid.local_boundary();
  return {distance, distance, {boundary.lower - around, boundary.upper + around}, kProofExcess, true};
}

double derivative_rounding(const Segment& segment, int order) noexcept {
  double size = 0.0;
  for (const Vec3& point : segment.points) size = larger(size, size_of(point));
  return kPointUlps * kUlp * size * amplification(segment.duration, order);
}

double hodograph_rounding(const Segment& segment, int order) noexcept {
  double extent = 0.0;
  for (const Vec3& point : segment.points) {
    for (int a = 0; a < 3; ++a) extent = larger(extent, absolute(axis(point, a) - axis(segment.points[0], a)));
  }
  return kDifferenceUlps * kUlp * extent * amplification(segment.duration, order);
}

}  // namespace tern
