// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "prove/cut_off.hpp"

#include "base/math.hpp"
#include "base/work.hpp"
#include "grid/bit_rows.hpp"
#include "prove/cuts.hpp"
#include "prove/hull_clear.hpp"

namespace tern {
namespace {

/// By how much the square of a unit normal may miss 1. Planes are placed by the normal's own length, so this is only to
/// keep out numbers that overflow.
constexpr double kUnitWithin = 1e-6;

/// If a normal's x moves a whole row by no more than this, metres, all voxels of the row count alike: as the nearer end
/// of the row.
constexpr double kFlat = 1e-11;

/// The voxels along an axis that are nearer to [lower, upper] than the distance.
IndexRange voxels_near(double lower, double upper, double distance, double cell, std::int32_t count) {
  IndexRange range = voxels_within(lower, upper, distance, cell, count);
  while (range.begin < range.end && lower - (range.begin + 1) * cell >= distance) ++range.begin;
  while (range.begin < range.end && (range.end - 1) * cell - upper >= distance) --range.end;
  return range;
}

/// 0: voxels of a row count alike; 1 or 2: the plane cuts off voxels from the lower end of x, or from the upper end.
int sign_of(const Grid& grid, const Vec3& n) {
  const double row = grid.spec().dims.x * grid.spec().cell;
  if (!(absolute(n.x) * row > kFlat)) return 0;
  return n.x < 0.0 ? 1 : 2;
}

/// The plane through the hull's furthest point along the normal.
PlaneCut cut_along(const Grid& grid, const Vec3& n, const Vec3* points, int count, double distance) {
  const GridSpec& spec = grid.spec();
  PlaneCut cut{n.y, n.z, support_of(n, points, count) + distance * length(n), 0.0};
  if (sign_of(grid, n) != 0) {
    cut.per_x = 1.0 / (n.x * spec.cell);
  } else {
    cut.reach -= smaller(0.0, n.x * (spec.dims.x * spec.cell));
  }
  return cut;
}

/// Axes need no hint: the range of voxels is bounded by the hull's box.
bool is_axis(const Vec3& n) {
  const double most = larger(larger(absolute(n.x), absolute(n.y)), absolute(n.z));
  return most >= 1.0;
}

void make_cuts(const Grid& grid, const Vec3* points, int count, const Hints& hints, double distance, PlaneCuts& cuts) {
  int sorted = 0;
  for (int sign = 0; sign < 3; ++sign) {
    for (int p = 0; p < hints.count; ++p) {
      const Vec3& normal = hints.planes[p].normal;
      if (!is_unit(normal) || is_axis(normal) || sign_of(grid, normal) != sign) continue;
      cuts.cut[sorted++] = cut_along(grid, normal, points, count, distance);
    }
    cuts.end[sign] = sorted;
  }
}

/// True if the row has an obstacle in the span.
bool has_obstacle(const std::uint64_t* row, const RowSpan& span) {
  if (span.begin >= span.end) return false;
  for (std::int32_t k = span.begin >> 6; k <= (span.end - 1) >> 6; ++k) {
    if ((row[k] & bits_within({span.begin, span.end}, k)) != 0) return true;
  }
  return false;
}

/// Rows of y and of z in a block. They are looked at together, since most blocks hold no obstacle near the hull, or are
/// cut off as a whole.
constexpr std::int32_t kBlock = 4;

/// The OR of a word of the block's rows in one plane.
std::uint64_t any_of_rows(const std::uint64_t* word, std::ptrdiff_t step, std::int32_t rows) {
  if (rows == kBlock) return word[0] | word[step] | word[2 * step] | word[3 * step];
  std::uint64_t any = 0;
  for (std::int32_t y = 0; y < rows; ++y, word += step) any |= *word;
  return any;
}

/// True if a row of the block has an obstacle in the span, which is not empty.
bool any_obstacle(const BitRows& obstacles, const RowBlock& block, const RowSpan& span) {
  const std::ptrdiff_t plane = obstacles.index(0, 1);
  for (std::int32_t k = span.begin >> 6; k <= (span.end - 1) >> 6; ++k) {
    const std::uint64_t* word = obstacles.row(block.lo.y, block.lo.z) + k;
    std::uint64_t any = 0;
    for (std::int32_t z = block.lo.z; z <= block.hi.z; ++z, word += plane) {
      any |= any_of_rows(word, obstacles.row_words, block.hi.y - block.lo.y + 1);
    }
    if ((any & bits_within({span.begin, span.end}, k)) != 0) return true;
  }
  return false;
}

/// True if the cuts take every obstacle of the block. Looks at single rows only if there is an obstacle in the span
/// that the cuts leave of the whole block.
bool block_clear(const Grid& grid, const PlaneCuts& cuts, const RowBlock& block, Work& work) {
  const double cell = grid.spec().cell;
  const BitRows obstacles = GridAccess::obstacles(grid);
  const RowSpan span = uncut(cell, cuts, block);
  work.spend(ops::kRow + 4 * ops::kMultiplyAdd * cuts.end[2]);
  if (span.begin >= span.end || !any_obstacle(obstacles, block, span)) return true;
  const FewCuts few = cuts_within(cell, cuts, block, span);
  work.spend(2 * ops::kPiece + 8 * ops::kMultiplyAdd * cuts.end[2]);
  for (std::int32_t z = block.lo.z; z <= block.hi.z; ++z) {
    for (std::int32_t y = block.lo.y; y <= block.hi.y; ++y) {
      const std::uint64_t* const row = obstacles.row(y, z);
      if (!has_obstacle(row, span)) continue;
      work.spend(ops::kRow + 5 * ops::kMultiplyAdd * few.end[2]);
      if (has_obstacle(row, uncut(cell, cuts, few, {{span.begin, y, z}, {span.end - 1, y, z}}))) return false;
    }
  }
  return true;
}

std::int32_t last_of_block(std::int32_t begin, std::int32_t end) {
  return (begin + kBlock < end ? begin + kBlock : end) - 1;
}

}  // namespace

Hints hints_of(const Polyhedron& polyhedron) noexcept {
  if (polyhedron.count < 0 || polyhedron.count > kMaxPlanes) return {nullptr, 0};
  return {polyhedron.planes, polyhedron.count};
}

bool is_unit(const Vec3& normal) noexcept {
  return absolute(dot(normal, normal) - 1.0) <= kUnitWithin;
}

double support_of(const Vec3& normal, const Vec3* points, int count) noexcept {
  double most = dot(normal, points[0]);
  for (int i = 1; i < count; ++i) most = larger(most, dot(normal, points[i]));
  return most;
}

bool cut_off(const Grid& grid, const Vec3* points, int count, const Hints& hints, double distance,
             Work& work) noexcept {
  const GridSpec& spec = grid.spec();
  const Box box = box_around(points, count);
  const IndexRange xs = voxels_near(box.lower.x, box.upper.x, distance, spec.cell, spec.dims.x);
  const IndexRange ys = voxels_near(box.lower.y, box.upper.y, distance, spec.cell, spec.dims.y);
  const IndexRange zs = voxels_near(box.lower.z, box.upper.z, distance, spec.cell, spec.dims.z);
  work.spend(5 * ops::kPiece);
  if (xs.begin >= xs.end) return true;
  if ((ys.end - ys.begin) * (zs.end - zs.begin) > kMostRows) return false;
  const BitRows obstacles = GridAccess::obstacles(grid);
  PlaneCuts cuts;
  bool is_ready = false;
  for (std::int32_t z = zs.begin; z < zs.end; z += kBlock) {
    for (std::int32_t y = ys.begin; y < ys.end; y += kBlock) {
      const RowBlock block{{xs.begin, y, z}, {xs.end - 1, last_of_block(y, ys.end), last_of_block(z, zs.end)}};
      work.spend(ops::kRow);
      if (!any_obstacle(obstacles, block, {xs.begin, xs.end})) continue;
      if (!is_ready) {
        make_cuts(grid, points, count, hints, distance, cuts);
        work.spend(6 * ops::kDot * hints.count);
        is_ready = true;
      }
      if (!block_clear(grid, cuts, block, work)) return false;
    }
  }
  return true;
}

}  // namespace tern
