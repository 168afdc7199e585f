// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/tolerance.hpp"

#include <algorithm>

namespace tern_verify {
namespace {

constexpr int kGridUlps = 10;
constexpr int kWorldUlps = 4;
constexpr int kFenceUlps = 512;
constexpr int kJointUlps = 32;
constexpr int kBoundUlps = 8;

Rational size_of(const Point& p) {
  return abs(p[0]) + abs(p[1]) + abs(p[2]);
}

Rational extent_of(const Lattice& lattice) {
  return lattice.cell * (lattice.dims[0] + lattice.dims[1] + lattice.dims[2]);
}

Rational largest_coordinate(const Polygon<3>& points, const Point& base) {
  Rational largest = 0;
  for (const Point& point : points) {
    for (std::size_t a = 0; a < 3; ++a) largest = std::max<Rational>(largest, abs(point[a] - base[a]));
  }
  return largest;
}

/// 2^k 7! / (7 - k)! / duration^k.
Rational amplification(const Rational& duration, int derivative) {
  Rational factor = 1;
  for (int k = 0; k < derivative; ++k) factor *= Rational(2 * (7 - k)) / duration;
  return factor;
}

Rational derivative_rounding(const Segment& segment, int derivative) {
  return ulp() * kBoundUlps * largest_coordinate(segment.points, segment.points.front()) *
         amplification(segment.duration, derivative);
}

}  // namespace

Rational largest_gap(const Point& a, const Point& b) {
  Rational largest = 0;
  for (std::size_t i = 0; i < 3; ++i) largest = std::max<Rational>(largest, abs(a[i] - b[i]));
  return largest;
}

Tolerance tolerance_of(const Problem& problem, const Lattice& lattice, const Plan& plan) {
  // A nanometre; with voxels larger than a metre, a billionth of a voxel.
  const Rational nanometre = decimal(1, 9) * std::max<Rational>(1, problem.cell);
  const Rational world = ulp() * kWorldUlps * (size_of(lattice.origin) + size_of(plan.origin));
  const Rational grid = ulp() * kGridUlps * extent_of(lattice) + world;
  Tolerance tolerance;
  tolerance.half_space = nanometre + grid;
  tolerance.point = nanometre + grid + decimal(2, 9) * problem.cell;
  tolerance.fence = nanometre + grid + ulp() * kFenceUlps * extent_of(lattice);
  tolerance.via = nanometre + grid;
  tolerance.place = grid;
  return tolerance;
}

Rational joint_tolerance(const Segment& segment, int derivative) {
  if (derivative == 0) return 0;
  return ulp() * kJointUlps * largest_coordinate(segment.points, {0, 0, 0}) *
         amplification(segment.duration, derivative);
}

Rational bound_tolerance(const Segment& segment, const Bound& bound) {
  const Rational rounding = derivative_rounding(segment, bound.derivative);
  if (bound.axis == kThrust) return decimal(3, 8) * (bound.most + gravity()) + 2 * rounding;
  return decimal(3, 8) * bound.most + (bound.axis == kHorizontal ? 2 : 1) * rounding;
}

Rational tilt_tolerance(const Segment& segment, const Rational& slope) {
  return decimal(3, 8) * gravity() + derivative_rounding(segment, 2) * (2 + 2 / slope);
}

Rational turn_tolerance(const Segment& segment, const Rational& rate, const Rational& least_thrust) {
  const Rational rounding = 2 * derivative_rounding(segment, 3) + 4 * rate * derivative_rounding(segment, 2);
  return decimal(3, 8) * rate + rounding / least_thrust;
}

}  // namespace tern_verify
