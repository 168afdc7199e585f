// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Checks whether points and segments keep their clearance from the obstacle layer. Reads the layer a word at a time:
// each run of obstacle voxels along x is one box.
#include "base/math.hpp"
#include "grid/distance.hpp"
#include "grid/lattice.hpp"
#include "grid/touching.hpp"

namespace tern {
namespace {

/// The segment that must keep clear of the obstacles, and the distance that it must keep.
struct Probe {
  Vec3 a;
  Vec3 b;
  double shrink;          ///< boxes are shrunk by this on each side
  double needed_squared;  ///< least squared distance from the shrunk boxes
  double direction;       ///< direction_tolerance
};

/// If the radius exceeds the tolerance, the boxes stay as they are. If it does not, the segment may touch a surface:
/// boxes shrink by the tolerance minus the radius, and the segment must not meet the shrunk boxes.
Probe make_probe(const GridSpec& spec, const Vec3& a, const Vec3& b, double radius, double tolerance) {
  const double direction = direction_tolerance(spec);
  if (radius > tolerance) return {a, b, 0.0, (radius - tolerance) * (radius - tolerance), direction};
  // The segment may enter a box by a little less than the tolerance, because the measured distance is rounded.
  constexpr double kHair = 0.05;
  return {a, b, tolerance - radius, kHair * kHair * tolerance * tolerance, direction};
}

/// The corners of a shrunk box lie deeper in the box than the tolerance. Near a corner, the best plane between segment
/// and box decides.
bool keeps_clear(const Probe& probe, const Box& box) {
  const double s = probe.shrink;
  const Box shrunk{{box.lower.x + s, box.lower.y + s, box.lower.z + s},
                   {box.upper.x - s, box.upper.y - s, box.upper.z - s}};
  const double squared = segment_box_distance_squared(probe.a, probe.b, shrunk);
  if (squared < probe.needed_squared) return false;
  if (squared >= 3.0 * s * s) return true;
  return separating_normal(probe.a, probe.b, box, probe.direction).room >= -s;
}

bool in_boundary(const Grid& grid, const Vec3& local, double tolerance) {
  const Box boundary = grid.local_boundary();
  for (int a = 0; a < 3; ++a) {
    // Written so that NaN is outside.
    if (!(axis(local, a) >= axis(boundary.lower, a) - tolerance)) return false;
    if (!(axis(local, a) <= axis(boundary.upper, a) + tolerance)) return false;
  }
  return true;
}

/// Voxels on one axis that may lie within the radius of [from, to]; one more on each side forgives all rounding.
IndexRange voxels_near(const GridSpec& spec, double from, double to, double radius, int a) {
  const std::int32_t count = axis(spec.dims, a);
  const std::int32_t begin = floor_index((smaller(from, to) - radius) / spec.cell, 1, count + 1) - 1;
  const std::int32_t end = floor_index((larger(from, to) + radius) / spec.cell, -2, count - 2) + 2;
  return {begin, end};
}

/// A bundle of rows, ANDed: `deep` planes of `wide` rows each, both 1 or 2. Bundles of more than one row close the gap
/// of width zero between neighbouring cubes. Only a radius of zero could pass it.
struct Bundle {
  std::int32_t wide;
  std::int32_t deep;
};

/// Word k of the AND of all rows of the bundle at (y, z): voxels along x at which every row has an obstacle.
std::uint64_t bundle_word(const Grid& grid, const Bundle& bundle, std::int32_t y, std::int32_t z, std::int32_t k) {
  std::uint64_t word = ~std::uint64_t{0};
  for (std::int32_t j = 0; j < bundle.deep; ++j) {
    for (std::int32_t i = 0; i < bundle.wide; ++i) word &= grid.obstacle_row(y + i, z + j)[k];
  }
  return word;
}

/// One past the last voxel of the run that begins at x, no further than `end`.
std::int32_t run_end(const Grid& grid, const Bundle& bundle, std::int32_t y, std::int32_t z, std::int32_t x,
                     std::int32_t end) {
  while (x < end) {
    const std::uint64_t gaps = ~bundle_word(grid, bundle, y, z, x >> 6) >> (x & 63);
    if (gaps != 0) {
      x += __builtin_ctzll(gaps);
      return x < end ? x : end;
    }
    x = (x | 63) + 1;
  }
  return end;
}

bool row_clear(const Grid& grid, const Probe& probe, const Bundle& bundle, const IndexRange& range, std::int32_t y,
               std::int32_t z) {
  const double cell = grid.spec().cell;
  for (std::int32_t x = range.begin; x < range.end;) {
    const std::uint64_t rest = bundle_word(grid, bundle, y, z, x >> 6) >> (x & 63);
    if (rest == 0) {
      x = (x | 63) + 1;
      continue;
    }
    x += __builtin_ctzll(rest);
    if (x >= range.end) break;
    const std::int32_t stop = run_end(grid, bundle, y, z, x, range.end);
    const Box box{{x * cell, y * cell, z * cell}, {stop * cell, (y + bundle.wide) * cell, (z + bundle.deep) * cell}};
    if (!keeps_clear(probe, box)) return false;
    x = stop;
  }
  return true;
}

bool bundles_clear(const Grid& grid, const Probe& probe, const Bundle& bundle, double radius) {
  const GridSpec& spec = grid.spec();
  const IndexRange x = voxels_near(spec, probe.a.x, probe.b.x, radius, 0);
  const IndexRange y = voxels_near(spec, probe.a.y, probe.b.y, radius, 1);
  const IndexRange z = voxels_near(spec, probe.a.z, probe.b.z, radius, 2);
  for (std::int32_t k = z.begin; k + bundle.deep <= z.end; ++k) {
    for (std::int32_t j = y.begin; j + bundle.wide <= y.end; ++j) {
      if (!row_clear(grid, probe, bundle, x, j, k)) return false;
    }
  }
  return true;
}

}  // namespace

bool segment_clear(const Grid& grid, const Vec3& a, const Vec3& b, double radius) noexcept {
  const double tolerance = contact_tolerance(grid.spec());
  if (!(radius >= 0.0) || !in_boundary(grid, a, tolerance) || !in_boundary(grid, b, tolerance)) return false;
  const Probe probe = make_probe(grid.spec(), a, b, radius, tolerance);
  if (!bundles_clear(grid, probe, {1, 1}, radius)) return false;
  if (radius > tolerance) return true;
  return bundles_clear(grid, probe, {2, 1}, radius) && bundles_clear(grid, probe, {1, 2}, radius) &&
         bundles_clear(grid, probe, {2, 2}, radius);
}

/// With radius 0, rows are read four times: alone, in bundles of two along y, of two along z, and of four.
Operations clear_operations(const GridSpec& spec, const Vec3& way, double radius) noexcept {
  // A line may lead far out of the grid; only rows of the grid are read.
  const auto crossed = [&](double along, std::int32_t count) {
    return static_cast<Operations>(smaller((absolute(along) + 2.0 * radius) / spec.cell + 2.0, count));
  };
  return (radius > 0.0 ? 1 : 4) * ops::kRow * crossed(way.y, spec.dims.y) * crossed(way.z, spec.dims.z);
}

bool point_clear(const Grid& grid, const Vec3& local, double radius) noexcept {
  return segment_clear(grid, local, local, radius);
}

}  // namespace tern
