// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "check/check_stage.hpp"
#include "check/cuts.hpp"
#include "grid/bit_rows.hpp"

namespace tern {
namespace {

/// Instructions of a polyhedron, of a block of rows, of a half-space for a block, of going through a block's rows, of a
/// row with an obstacle, and of a half-space for such a row.
constexpr std::uint32_t kPolyhedronEffort = 4000;
constexpr std::uint32_t kBlockEffort = 150;
constexpr std::uint32_t kBlockPlaneEffort = 12;
constexpr std::uint32_t kRowsEffort = 400;
constexpr std::uint32_t kRowEffort = 60;
constexpr std::uint32_t kRowPlaneEffort = 14;

/// A box around the polyhedron, from those of its planes that are axis-aligned. The grid bounds it where there are
/// none.
Box bounding_box(const Grid& grid, const Polyhedron& polyhedron) {
  const GridSpec& spec = grid.spec();
  Box box{{0.0, 0.0, 0.0}, {spec.dims.x * spec.cell, spec.dims.y * spec.cell, spec.dims.z * spec.cell}};
  for (int p = 0; p < all_planes(polyhedron); ++p) {
    const Halfspace& plane = polyhedron.planes[p];
    for (int a = 0; a < 3; ++a) {
      if (axis(plane.normal, a) >= 1.0) axis(box.upper, a) = smaller(axis(box.upper, a), plane.offset);
      if (axis(plane.normal, a) <= -1.0) axis(box.lower, a) = larger(axis(box.lower, a), -plane.offset);
    }
  }
  return box;
}

std::int32_t clamp_index(double cells, std::int32_t count) {
  // Compared as doubles first: a far coordinate does not fit an integer.
  if (!(cells > 0.0)) return 0;
  if (cells >= static_cast<double>(count)) return count - 1;
  return static_cast<std::int32_t>(cells);
}

RowBlock voxels_near(const Grid& grid, const Polyhedron& polyhedron) {
  const GridSpec& spec = grid.spec();
  const Box box = bounding_box(grid, polyhedron);
  const double reach = spec.clearance() + spec.cell;  // a cell more than needed costs little and allows for rounding
  return {{clamp_index((box.lower.x - reach) / spec.cell, spec.dims.x),
           clamp_index((box.lower.y - reach) / spec.cell, spec.dims.y),
           clamp_index((box.lower.z - reach) / spec.cell, spec.dims.z)},
          {clamp_index((box.upper.x + reach) / spec.cell, spec.dims.x),
           clamp_index((box.upper.y + reach) / spec.cell, spec.dims.y),
           clamp_index((box.upper.z + reach) / spec.cell, spec.dims.z)}};
}

/// Units in the last place by which the square of a unit normal may miss 1.
constexpr double kUnitUlps = 16.0;

/// If a normal's x moves a whole row by no more than this part of the tolerance, all voxels of the row count alike: as
/// the nearer end of the row.
constexpr double kSlopeShare = 0.01;

PlaneCut cut_of(const Grid& grid, const Halfspace& plane, double tolerance) {
  const GridSpec& spec = grid.spec();
  const double row = spec.dims.x * spec.cell;
  const Vec3& n = plane.normal;
  PlaneCut cut{n.y, n.z, n.y < 0.0 ? 1 : 0, n.z < 0.0 ? 1 : 0, plane.offset + spec.clearance() - tolerance, 0.0};
  if (absolute(n.x) * row > kSlopeShare * tolerance) {
    cut.per_x = 1.0 / (n.x * spec.cell);
  } else {
    cut.reach -= smaller(0.0, n.x * row);
  }
  return cut;
}

int sign_of(const PlaneCut& cut) {
  return cut.per_x < 0.0 ? 1 : (cut.per_x > 0.0 ? 2 : 0);
}

PlaneCuts cuts_of(const Grid& grid, const Polyhedron& polyhedron, double tolerance) {
  const int planes = all_planes(polyhedron);
  PlaneCut all[kMaxPlanes];
  for (int p = 0; p < planes; ++p) all[p] = cut_of(grid, polyhedron.planes[p], tolerance);
  PlaneCuts cuts;
  int count = 0;
  for (int sign = 0; sign < 3; ++sign) {
    for (int p = 0; p < planes; ++p) {
      if (sign_of(all[p]) == sign) cuts.cut[count++] = all[p];
    }
    cuts.end[sign] = count;
  }
  return cuts;
}

constexpr std::int32_t kNoObstacle = -1;

/// The least x of an obstacle in the span of the row.
std::int32_t first_obstacle(const std::uint64_t* row, const RowSpan& span) {
  if (span.begin >= span.end) return kNoObstacle;
  for (std::int32_t k = span.begin >> 6; k <= (span.end - 1) >> 6; ++k) {
    const std::uint64_t word = row[k] & bits_within({span.begin, span.end}, k);
    if (word != 0) return k * 64 + __builtin_ctzll(word);
  }
  return kNoObstacle;
}

/// Rows of y and of z in a block. They are looked at together, since most blocks are cut off as a whole or hold no
/// obstacle.
constexpr std::int32_t kBlock = 4;

/// The OR of a word of the block's rows in one plane.
std::uint64_t any_of_rows(const std::uint64_t* word, std::ptrdiff_t step, std::int32_t rows) {
  if (rows == kBlock) return word[0] | word[step] | word[2 * step] | word[3 * step];
  std::uint64_t any = 0;
  for (std::int32_t y = 0; y < rows; ++y, word += step) any |= *word;
  return any;
}

/// True if a row of the block has an obstacle in the span.
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

/// True if the half-spaces cut off every obstacle of the block. Looks at single rows only if there is an obstacle in
/// the span that the half-spaces leave of the whole block. `obstacle` receives the first one that is not cut off.
bool block_clear(const Grid& grid, const PlaneCuts& cuts, const LayerDepths& depths, const RowBlock& block,
                 Voxel& obstacle, std::uint32_t& effort) {
  const double cell = grid.spec().cell;
  const RowSpan span = uncut(cell, cuts, block, depths);
  effort += kBlockEffort + effort_of(kBlockPlaneEffort, cuts.end[2]);
  if (span.begin >= span.end || !any_obstacle(GridView::obstacles(grid), block, span)) return true;
  const PlaneCuts few = cuts_within(cell, cuts, block, span);
  effort += effort_of(kBlockPlaneEffort, 2 * cuts.end[2]) + kRowsEffort;
  for (std::int32_t z = block.lo.z; z <= block.hi.z; ++z) {
    for (std::int32_t y = block.lo.y; y <= block.hi.y; ++y) {
      const std::uint64_t* const row = grid.obstacle_row(y, z);
      if (first_obstacle(row, span) == kNoObstacle) continue;
      effort += kRowEffort + effort_of(kRowPlaneEffort, few.end[2]);
      const std::int32_t x = first_obstacle(row, uncut(cell, few, {{span.begin, y, z}, {span.end - 1, y, z}}));
      if (x == kNoObstacle) continue;
      obstacle = {x, y, z};
      return false;
    }
  }
  return true;
}

std::int32_t block_end(std::int32_t begin, std::int32_t last) {
  return begin + (kBlock - 1) < last ? begin + (kBlock - 1) : last;
}

bool well_formed(const Polyhedron& polyhedron) {
  if (polyhedron.count < 1 || polyhedron.count > kMaxPlanes) return false;
  if (polyhedron.redundant < 0 || polyhedron.redundant > kMaxPlanes - polyhedron.count) return false;
  for (int p = 0; p < all_planes(polyhedron); ++p) {
    const Halfspace& plane = polyhedron.planes[p];
    if (!finite(plane.normal) || !finite(plane.offset)) return false;
    if (absolute(dot(plane.normal, plane.normal) - 1.0) > kUnitUlps * kUlp) return false;
  }
  return true;
}

/// By how many metres, along the half-space's normal, the voxel is too near to be cut off.
double missing_to(const Grid& grid, const Halfspace& plane, const Voxel& voxel, double tolerance) {
  const double cell = grid.spec().cell;
  const int index[3] = {voxel.x, voxel.y, voxel.z};
  double depth = 0.0;
  for (int a = 0; a < 3; ++a) {
    const double normal = axis(plane.normal, a);
    depth += normal * (cell * (index[a] + (normal < 0.0 ? 1 : 0)));
  }
  return (plane.offset + grid.spec().clearance() - tolerance) - depth;
}

/// Notes the half-space that comes nearest to cutting the voxel off, and the metres that it lacks.
bool refuse_obstacle(const Grid& grid, const Polyhedron& polyhedron, const Voxel& voxel, double tolerance,
                     CheckReport& found) {
  found.voxel = voxel;
  for (int p = 0; p < all_planes(polyhedron); ++p) {
    const double missing = larger(0.0, missing_to(grid, polyhedron.planes[p], voxel, tolerance));
    if (found.plane >= 0 && !(missing < found.excess)) continue;
    found.plane = p;
    found.excess = missing;
  }
  return refuse(Finding::kObstacle, found);
}

}  // namespace

bool polyhedron_clear(const Grid& grid, const Polyhedron& polyhedron, CheckReport& found,
                      std::uint32_t* effort) noexcept {
  if (!well_formed(polyhedron)) return refuse(Finding::kMalformed, found);
  const RowBlock range = voxels_near(grid, polyhedron);
  const double tolerance = check_distance(grid) + grid_rounding(grid);
  const PlaneCuts cuts = cuts_of(grid, polyhedron, tolerance);
  Voxel obstacle{};
  std::uint32_t spent = kPolyhedronEffort;
  for (std::int32_t z = range.lo.z; z <= range.hi.z; z += kBlock) {
    const std::int32_t z_end = block_end(z, range.hi.z);
    const LayerDepths depths(cuts, z * grid.spec().cell, (z_end + 1) * grid.spec().cell);
    for (std::int32_t y = range.lo.y; y <= range.hi.y; y += kBlock) {
      const RowBlock block{{range.lo.x, y, z}, {range.hi.x, block_end(y, range.hi.y), z_end}};
      if (!block_clear(grid, cuts, depths, block, obstacle, spent)) {
        if (effort != nullptr) *effort += spent;
        return refuse_obstacle(grid, polyhedron, obstacle, tolerance, found);
      }
    }
  }
  if (effort != nullptr) *effort += spent;
  return true;
}

}  // namespace tern
