// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the free voxel nearest to a point. Reads rows along x, a word at a time, in growing squares around the point's
// row.
#include "base/math.hpp"
#include "grid/distance.hpp"
#include "grid/lattice.hpp"

namespace tern {
namespace {

bool precedes(const Voxel& a, const Voxel& b) {
  if (a.z != b.z) return a.z < b.z;
  if (a.y != b.y) return a.y < b.y;
  return a.x < b.x;
}

void offer(NearestFree& nearest, const Voxel& voxel) {
  const Vec3 apart{voxel.x + 0.5 - nearest.point.x, voxel.y + 0.5 - nearest.point.y, voxel.z + 0.5 - nearest.point.z};
  const double squared = dot(apart, apart);
  if (nearest.found) {
    if (squared > nearest.distance_squared) return;
    if (!(squared < nearest.distance_squared) && !precedes(voxel, nearest.voxel)) return;
  }
  nearest.found = true;
  nearest.distance_squared = squared;
  nearest.voxel = voxel;
}

/// The last free voxel of a row before x; -1 if there is none.
std::int32_t free_before(const std::uint64_t* row, std::int32_t x) {
  std::uint64_t mask = bits_before(x);
  for (std::int32_t k = x >> 6; k >= 0; --k, mask = kAllBits) {
    const std::uint64_t free = ~row[k] & mask;
    if (free != 0) return 64 * k + 63 - __builtin_clzll(free);
  }
  return -1;
}

/// The first free voxel of a row at or after x; -1 if there is none. Padding counts as blocked.
std::int32_t free_after(const std::uint64_t* row, std::int32_t words, std::int32_t x) {
  std::uint64_t mask = bits_from(x);
  for (std::int32_t k = x >> 6; k < words; ++k, mask = kAllBits) {
    const std::uint64_t free = ~row[k] & mask;
    if (free != 0) return 64 * k + __builtin_ctzll(free);
  }
  return -1;
}

/// Offers two voxels of a row: the last free voxel before x, and the first at or after x. No other can be nearest.
void offer_row(const Grid& grid, std::int32_t x, std::int32_t y, std::int32_t z, NearestFree& nearest) {
  const std::uint64_t* row = grid.blocked_row(y, z);
  const std::int32_t before = free_before(row, x);
  if (before >= 0) offer(nearest, {before, y, z});
  const std::int32_t after = free_after(row, grid.row_words(), x);
  if (after >= 0) offer(nearest, {after, y, z});
}

/// Those of the indices 0 .. count - 1 that are at most k from the centre.
IndexRange around(std::int32_t center, std::int32_t k, std::int32_t count) {
  return {center < k ? 0 : center - k, center + k < count ? center + k + 1 : count};
}

/// Offers the rows of a square: along y or z, whichever is further, they are k rows from the centre. Returns their
/// number.
int offer_square(const Grid& grid, const Voxel& center, std::int32_t k, NearestFree& nearest) {
  const Voxel& dims = grid.spec().dims;
  const IndexRange all_y = around(center.y, k, dims.y);
  const IndexRange all_z = around(center.z, k, dims.z);
  int rows = 0;
  const auto offer_one = [&](std::int32_t y, std::int32_t z) {
    offer_row(grid, center.x, y, z, nearest);
    ++rows;
  };
  for (std::int32_t z = all_z.begin; z < all_z.end; ++z) {
    if (z == center.z - k || z == center.z + k) {
      for (std::int32_t y = all_y.begin; y < all_y.end; ++y) offer_one(y, z);
      continue;
    }
    if (center.y - k >= 0) offer_one(center.y - k, z);
    if (center.y + k < dims.y) offer_one(center.y + k, z);
  }
  return rows;
}

}  // namespace

void nearest_begin(NearestFree& nearest, const Grid& grid, const Vec3& local) noexcept {
  const GridSpec& spec = grid.spec();
  nearest.found = false;
  nearest.distance_squared = 0.0;
  nearest.square = nearest.last = 0;
  if (!grid.bound() || !finite(local)) return;
  nearest.point = {local.x / spec.cell, local.y / spec.cell, local.z / spec.cell};
  nearest.last = spec.dims.y > spec.dims.z ? spec.dims.y : spec.dims.z;
}

Progress nearest_advance(NearestFree& nearest, const Grid& grid, Work& work) noexcept {
  const Voxel& dims = grid.spec().dims;
  for (; nearest.square < nearest.last; ++nearest.square) {
    // The centres of the rows of square k are at least k - 0.5 rows away. The slack keeps voxels whose rounded
    // distances tie.
    const double least = nearest.square - 0.5 - 1e-6;
    if (nearest.found && least > 0.0 && nearest.distance_squared < least * least) break;
    if (!work.left()) return Progress::kMore;
    const Voxel center{floor_index(nearest.point.x, 0, dims.x - 1), floor_index(nearest.point.y, 0, dims.y - 1),
                       floor_index(nearest.point.z, 0, dims.z - 1)};
    const int rows = offer_square(grid, center, nearest.square, nearest);
    work.spend(ops::kPiece + (ops::kRow + ops::kWord * grid.row_words()) * rows);
  }
  return Progress::kDone;
}

}  // namespace tern
