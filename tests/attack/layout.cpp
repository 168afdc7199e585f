// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a world lies, how fine it is and how wide the robot.
#include "attack/world.hpp"

namespace tern_attack {
namespace {

double choose_cell(Rng& rng) {
  constexpr double kUsual[] = {0.02, 0.05, 0.1, 0.2, 0.25, 0.3, 0.5, 1.0};
  const double u = rng.unit();
  if (u < 0.45) return rng.pick(kUsual);
  if (u < 0.88) return rng.spread(0.02, 1.0);
  return rng.spread(10.0, 1e5);
}

double choose_offset(Rng& rng) {
  constexpr double kSizes[] = {1.0, 100.0, 1e3, 1e4, 1e5, 1e6, 1e7};
  if (rng.chance(0.35)) return 0.0;
  const double size = rng.sign() * rng.pick(kSizes);
  return rng.chance(0.3) ? size : size * rng.real(0.5, 1.0);
}

int choose_dimension(Rng& rng) {
  const double u = rng.unit();
  return 8 + static_cast<int>(32.0 * u * u * u * u);
}

/// Some 200 m to 10 km long, so that plans lie far from the grid's own origin.
void choose_far(Rng& rng, tern::GridSpec& spec) {
  const int turn = rng.integer(0, 2);
  spec.dims = {8, 8, 8};
  axis(spec.dims, turn) = rng.integer(64, 512);
  spec.cell = rng.spread(2.0, 1e4 / axis(spec.dims, turn));
}

/// The clearance in voxels that ways are made for, and the radius that goes with it.
int choose_radius(Rng& rng, Family family, tern::GridSpec& spec) {
  const bool narrow =
      family == Family::kSlots || family == Family::kMaze || family == Family::kStairs || family == Family::kTunnels;
  const double u = rng.unit();
  const int k = rng.chance(0.8) ? 1 : 2;
  if (u < 0.25 || (family == Family::kCorners && u < 0.6)) {
    spec.radius = 0.0;
    return 0;
  }
  if (u < 0.4 || (family == Family::kCorners && u < 0.9)) {
    spec.radius = rng.chance(0.7) ? 1e-9 : rng.spread(1e-12, 1e-6);
    return spec.radius <= 1e-9 ? 0 : 1;
  }
  if (u < 0.6) {
    spec.radius = k * spec.cell;
    return k;
  }
  if (u < 0.75) {
    spec.radius = k * std::sqrt(2.0) * spec.cell;
    return static_cast<int>(std::ceil(k * 1.42));
  }
  spec.radius = rng.real(0.0, narrow ? 1.5 : 2.5) * spec.cell;
  return static_cast<int>(std::ceil(spec.radius / spec.cell));
}

/// The whole grid, or whole cells less, or planes well off the lattice.
void choose_boundary(Rng& rng, tern::GridSpec& spec) {
  const double u = rng.unit();
  for (int a = 0; a < 3; ++a) {
    const double origin = axis(spec.origin, a);
    const int count = axis(spec.dims, a);
    double lower = 0.0;
    double upper = count;
    if (u > 0.6 && u < 0.85) {
      lower = rng.integer(0, 1);
      upper = count - rng.integer(0, 1);
    } else if (u >= 0.85) {
      lower = rng.real(0.01, 1.2);
      upper = count - rng.real(0.01, 1.2);
      if (lower - std::floor(lower) > 0.99) lower -= 0.02;
      if (upper - std::floor(upper) > 0.99) upper -= 0.02;
    }
    axis(spec.boundary.lower, a) = origin + lower * spec.cell;
    axis(spec.boundary.upper, a) = origin + upper * spec.cell;
  }
}

}  // namespace

void make_world(Rng& rng, Family family, World& world) {
  tern::GridSpec& spec = world.spec;
  spec.cell = choose_cell(rng);
  for (int a = 0; a < 3; ++a) axis(spec.dims, a) = choose_dimension(rng);
  if (family == Family::kFar) choose_far(rng, spec);
  if (family == Family::kFences) spec.cell = rng.real(0.1, 2.0);
  // Needles of fences far from the world's origin are the rounding of their own coordinates.
  for (int a = 0; a < 3; ++a) {
    axis(spec.origin, a) = family == Family::kFences ? (rng.chance(0.5) ? 0.0 : rng.real(-50, 50)) : choose_offset(rng);
  }
  const int half = choose_radius(rng, family, spec);
  if (family == Family::kChanges && rng.chance(0.06)) {
    // Wide enough for searches that keep what they found out about the map.
    spec.dims = {rng.integer(100, 140), rng.integer(80, 120), rng.integer(4, 8)};
    spec.radius = 0.0;
  }
  choose_boundary(rng, spec);
  world.solid.assign(static_cast<std::size_t>(world.count()), 0);
  fill(rng, family, half, world);
}

}  // namespace tern_attack
