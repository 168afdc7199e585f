// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/scan.hpp"

#include "path/neighbourhood.hpp"
#include "path/prune.hpp"

namespace tern {
namespace {

/// The rows around a line along x: its own first, then those beside it that lie inside the grid.
struct RowBundle {
  const std::uint64_t* own;
  const std::uint64_t* beside[8];
  int count;
  std::int32_t words;
};

RowBundle bundle(const Grid& grid, const Voxel& v) {
  const Voxel& dims = grid.spec().dims;
  RowBundle rows{grid.blocked_row(v.y, v.z), {}, 0, grid.row_words()};
  for (std::int32_t z = v.z - 1; z <= v.z + 1; ++z) {
    for (std::int32_t y = v.y - 1; y <= v.y + 1; ++y) {
      if (y < 0 || z < 0 || y >= dims.y || z >= dims.z || (y == v.y && z == v.z)) continue;
      rows.beside[rows.count++] = grid.blocked_row(y, z);
    }
  }
  return rows;
}

/// Voxels of word k where a scan towards higher (lower) x must look closer: blocked, or beside a voxel that is free
/// while the one beside its predecessor is blocked.
template <bool kUp>
std::uint64_t stops(const RowBundle& rows, std::int32_t k) {
  std::uint64_t found = rows.own[k];
  const std::int32_t before = kUp ? k - 1 : k + 1;
  const bool has_before = kUp ? before >= 0 : before < rows.words;
  for (int i = 0; i < rows.count; ++i) {
    const std::uint64_t row = rows.beside[i][k];
    const std::uint64_t last = has_before ? rows.beside[i][before] : 0;
    const std::uint64_t behind = kUp ? (row << 1 | last >> 63) : (row >> 1 | last << 63);
    found |= behind & ~row;
  }
  return found;
}

/// The first stop at or beyond x; -1 where the row ends before one.
template <bool kUp>
std::int32_t next_stop(const RowBundle& rows, std::int32_t x) {
  if (x < 0) return -1;
  std::uint64_t ahead = kUp ? ~std::uint64_t{0} << (x & 63) : ~std::uint64_t{0} >> (63 - (x & 63));
  for (std::int32_t k = x >> 6; k >= 0 && k < rows.words; k += kUp ? 1 : -1) {
    const std::uint64_t found = stops<kUp>(rows, k) & ahead;
    if (found != 0) return k * 64 + (kUp ? __builtin_ctzll(found) : 63 - __builtin_clzll(found));
    ahead = ~std::uint64_t{0};
  }
  return -1;
}

template <bool kUp>
bool scan_x(const Grid& grid, const Voxel& goal, const Voxel& from, Voxel& found) {
  const RowBundle rows = bundle(grid, from);
  const int move = direction(kUp ? 1 : -1, 0, 0);
  const std::int32_t step = kUp ? 1 : -1;
  const std::int32_t last = grid.spec().dims.x;
  const bool goal_ahead = goal.y == from.y && goal.z == from.z && (goal.x - from.x) * step > 0;
  found = from;
  // Each round ends the scan or passes a voxel for good.
  for (std::int32_t x = from.x + step; x >= 0 && x < last; x += step) {
    x = next_stop<kUp>(rows, x);
    if (goal_ahead && (x < 0 || (x - goal.x) * step >= 0)) {
      found.x = goal.x;
      return true;
    }
    if (x < 0 || (rows.own[x >> 6] >> (x & 63) & 1u) != 0) return false;
    found.x = x;
    if (forced_moves(move, free_cells(grid, found)) != 0) return true;
  }
  return false;
}

/// Along y and z: voxel by voxel.
bool scan_stepwise(const Grid& grid, const Voxel& goal, const Voxel& from, int move, Voxel& found) {
  const Voxel step = offset(move);
  found = from + step;
  // At most kMaxDimension steps: the grid's face is blocked.
  while (grid.free(found)) {
    if (same(found, goal)) return true;
    if (forced_moves(move, free_cells(grid, found)) != 0) return true;
    found = found + step;
  }
  return false;
}

}  // namespace

bool scan_straight(const Grid& grid, const Voxel& goal, const Voxel& from, int move, Voxel& found) noexcept {
  if (move == direction(1, 0, 0)) return scan_x<true>(grid, goal, from, found);
  if (move == direction(-1, 0, 0)) return scan_x<false>(grid, goal, from, found);
  return scan_stepwise(grid, goal, from, move, found);
}

}  // namespace tern
