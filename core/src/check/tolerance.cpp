// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "check/tolerance.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

double size_of(const Vec3& v) {
  return (absolute(v.x) + absolute(v.y)) + absolute(v.z);
}

double extent_of(const Grid& grid) {
  const GridSpec& spec = grid.spec();
  return size_of({spec.dims.x * spec.cell, spec.dims.y * spec.cell, spec.dims.z * spec.cell});
}

/// The largest coordinate of the control points relative to `base`.
double largest_coordinate(const Segment& segment, const Vec3& base) {
  double size = 0.0;
  for (const Vec3& point : segment.points) {
    for (int a = 0; a < 3; ++a) size = larger(size, absolute(axis(point, a) - axis(base, a)));
  }
  return size;
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

double grid_rounding(const Grid& grid) noexcept {
  return kUlp * (kGridUlps * extent_of(grid) + kOriginUlps * size_of(grid.spec().origin));
}

double fence_tolerance(const Grid& grid) noexcept {
  return check_distance(grid) + grid_rounding(grid) + kCornerUlps * kUlp * extent_of(grid);
}

double place_rounding(const Grid& grid, const Trajectory& trajectory) noexcept {
  const double world = size_of(trajectory.origin) + size_of(grid.spec().origin);
  return grid_rounding(grid) + kOriginUlps * kUlp * world;
}

double lattice_rounding(const Grid& grid) noexcept {
  return 2.0 * kLatticeTolerance * grid.spec().cell;
}

double face_tolerance(const Grid& grid, double face) noexcept {
  const double rounding = kUlp * (kFaceRoundingUlps * absolute(face) + kGridUlps * extent_of(grid));
  return check_distance(grid) + lattice_rounding(grid) + rounding;
}

double derivative_rounding(const Segment& segment, int order) noexcept {
  constexpr Vec3 kOrigin{0.0, 0.0, 0.0};
  return kPointUlps * kUlp * largest_coordinate(segment, kOrigin) * amplification(segment.duration, order);
}

double hodograph_rounding(const Segment& segment, int order) noexcept {
  return kDifferenceUlps * kUlp * largest_coordinate(segment, segment.points[0]) *
         amplification(segment.duration, order);
}

}  // namespace tern
