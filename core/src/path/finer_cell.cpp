// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/finer_cell.hpp"

#include "base/math.hpp"
#include "grid/distance.hpp"
#include "grid/lattice.hpp"

namespace tern {
namespace {

/// Whole cells between a fine voxel and a coarse one on one axis, in fine cells.
std::int32_t gap_between(std::int32_t fine, std::int32_t coarse, std::int32_t parts) {
  const std::int32_t below = coarse * parts - fine - 1;
  const std::int32_t above = fine - (coarse + 1) * parts;
  const std::int32_t gap = below > above ? below : above;
  return gap > 0 ? gap : 0;
}

/// The coarse voxels on one axis that are at most `reach` fine cells away from a fine one.
IndexRange coarse_within(std::int32_t fine, std::int32_t reach, std::int32_t parts, std::int32_t count) {
  const std::int32_t low = fine - reach;
  const std::int32_t begin = low > 0 ? (low + parts - 1) / parts - 1 : 0;
  return overlap({0, count}, {begin, (fine + 1 + reach) / parts + 1});
}

bool row_has_obstacle(const std::uint64_t* row, const IndexRange& range) {
  for (std::int32_t k = range.begin >> 6; k <= (range.end - 1) >> 6; ++k) {
    if ((row[k] & bits_within(range, k)) != 0) return true;
  }
  return false;
}

/// True if the fine voxel keeps the radius from all obstacles of the coarse grid, by the rule of inflation.
bool keeps_radius(const Grid& grid, const Grid& fine, const Voxel& voxel, Work& work) {
  const Voxel& dims = grid.spec().dims;
  const std::int32_t parts = fine.spec().dims.x / dims.x;
  if (grid.obstacle({voxel.x / parts, voxel.y / parts, voxel.z / parts})) return false;
  const double cells = fine.spec().clearance() / fine.spec().cell;
  const double needed = cells * cells * (1.0 - 2.0 * kLatticeTolerance);
  if (!(needed > 0.0)) return true;
  const std::int32_t reach = floor_index(cells, 0, kMaxDimension);
  const IndexRange planes = coarse_within(voxel.z, reach, parts, dims.z);
  const IndexRange rows = coarse_within(voxel.y, reach, parts, dims.y);
  for (std::int32_t z = planes.begin; z < planes.end; ++z) {
    work.spend(ops::kRow * (rows.end - rows.begin));
    const double gap_z = gap_between(voxel.z, z, parts);
    for (std::int32_t y = rows.begin; y < rows.end; ++y) {
      const double gap_y = gap_between(voxel.y, y, parts);
      const double rest = needed - gap_z * gap_z - gap_y * gap_y;
      if (!(rest > 0.0)) continue;
      // The largest gap along x whose square is below the rest.
      const std::int32_t gap_x = ceil_index(square_root(rest), 1, kMaxDimension) - 1;
      if (row_has_obstacle(grid.obstacle_row(y, z), coarse_within(voxel.x, gap_x, parts, dims.x))) return false;
    }
  }
  return true;
}

bool is_inside(const Grid& fine, const Voxel& voxel) {
  for (int a = 0; a < 3; ++a) {
    if (!contains(inside_boundary(fine, a), axis(voxel, a))) return false;
  }
  return true;
}

bool resolves(const GridSpec& spec) {
  return resolves_cells(spec.origin.x, spec.cell) && resolves_cells(spec.origin.y, spec.cell) &&
         resolves_cells(spec.origin.z, spec.cell);
}

/// True if the point would join the voxel.
bool would_join(const World& world, const Grid& fine, const Vec3& point, const Voxel& voxel, Work& work) {
  if (!is_inside(fine, voxel) || !keeps_radius(world.voxels(), fine, voxel, work)) return false;
  if (!world.solids_clear(cube_of(fine, voxel))) return false;
  const Vec3 to = free_point(fine, voxel);
  work.spend(clear_operations(world.spec(), to - point, world.spec().clearance()));
  return world.line_clear(point, to);
}

}  // namespace

void finer_begin(FinerCell& finer, const Vec3& point) noexcept {
  finer.point = point;
  finer.halvings = 1;
  finer.candidate = 0;
  finer.cell = 0.0;
}

Progress finer_advance(FinerCell& finer, const World& world, Work& work) noexcept {
  for (; finer.halvings <= kFinerHalvings; ++finer.halvings) {
    Grid fine;
    if (!GridAccess::halved(world.voxels(), finer.halvings, fine) || !resolves(fine.spec())) return Progress::kDone;
    const Voxel home = fine.voxel_of(finer.point);
    for (; finer.candidate < kJoinCells; ++finer.candidate) {
      if (!work.left()) return Progress::kMore;
      const int k = finer.candidate;
      const Voxel voxel{home.x + k % kJoinWidth - kJoinReach, home.y + k / kJoinWidth % kJoinWidth - kJoinReach,
                        home.z + k / (kJoinWidth * kJoinWidth) - kJoinReach};
      work.spend(2 * ops::kPiece);
      if (!would_join(world, fine, finer.point, voxel, work)) continue;
      finer.cell = fine.spec().cell;
      return Progress::kDone;
    }
    finer.candidate = 0;
  }
  return Progress::kDone;
}

}  // namespace tern
