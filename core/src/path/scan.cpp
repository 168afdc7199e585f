// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/scan.hpp"

#include "grid/lattice.hpp"
#include "path/neighbourhood.hpp"
#include "path/prune.hpp"

namespace tern {
namespace {

/// Rows of the blocked layer along one axis: the line's own, and those beside it that lie inside the grid.
struct Line {
  TurnedLayer* turned;  ///< where the rows come from; null for the grid's own rows along x
  const std::uint64_t* own;
  const std::uint64_t* beside[8];
  std::int32_t count;
  std::int32_t words;
  // Tiles of a turned copy that the nine rows pass: along x and along the third axis, both inclusive.
  std::int32_t first_block, last_block;
  std::int32_t first_third, last_third;
};

void add_beside(Line& line, const std::uint64_t* row) {
  if (row != line.own) line.beside[line.count++] = row;
}

Line line_along_x(const Grid& grid, const Voxel& v) {
  const Voxel& dims = grid.spec().dims;
  Line line{nullptr, grid.blocked_row(v.y, v.z), {}, 0, grid.row_words(), 0, 0, 0, 0};
  for (std::int32_t z = v.z > 0 ? v.z - 1 : 0; z <= v.z + 1 && z < dims.z; ++z) {
    for (std::int32_t y = v.y > 0 ? v.y - 1 : 0; y <= v.y + 1 && y < dims.y; ++y) {
      add_beside(line, grid.blocked_row(y, z));
    }
  }
  return line;
}

Line line_turned(TurnedLayer& layer, const Grid& grid, const Voxel& v) {
  const std::int32_t t = axis(v, 3 - layer.axis);
  const std::int32_t third_count = axis(grid.spec().dims, 3 - layer.axis);
  const std::int32_t first_x = v.x > 0 ? v.x - 1 : 0;
  const std::int32_t last_x = v.x + 1 < layer.width ? v.x + 1 : v.x;
  const std::int32_t first_third = t > 0 ? t - 1 : 0;
  const std::int32_t last_third = t + 1 < third_count ? t + 1 : t;
  Line line{&layer, turned_row(layer, v.x, t), {}, 0, layer.words, first_x >> 6, last_x >> 6, first_third, last_third};
  for (std::int32_t third = first_third; third <= last_third; ++third) {
    for (std::int32_t x = first_x; x <= last_x; ++x) add_beside(line, turned_row(layer, x, third));
  }
  return line;
}

/// Makes word k of the line's rows readable.
void prepare(const Line& line, const Grid& grid, std::int32_t k) {
  if (line.turned == nullptr) return;
  for (std::int32_t third = line.first_third; third <= line.last_third; ++third) {
    for (std::int32_t block = line.first_block; block <= line.last_block; ++block) {
      turned_prepare(*line.turned, grid, block, third, k);
    }
  }
}

/// Voxels of word k where a scan must look closer: blocked, or beside a voxel that is free while the one beside its
/// predecessor is blocked. Bit 0 (63 downwards) needs word `before`, -1 where there is none.
template <bool kUp>
std::uint64_t stops(const Line& line, std::int32_t k, std::int32_t before) {
  std::uint64_t found = line.own[k];
  for (std::int32_t i = 0; i < line.count; ++i) {
    const std::uint64_t row = line.beside[i][k];
    const std::uint64_t last = before >= 0 ? line.beside[i][before] : 0;
    const std::uint64_t behind = kUp ? (row << 1 | last >> 63) : (row >> 1 | last << 63);
    found |= behind & ~row;
  }
  return found;
}

/// The first stop beyond `at`; -1 where the row ends before one.
template <bool kUp>
std::int32_t next_stop(const Line& line, const Grid& grid, std::int32_t at) {
  std::int32_t k = at >> 6;
  std::int32_t before = -1;
  std::uint64_t ahead = kUp ? ~std::uint64_t{1} << (at & 63) : (std::uint64_t{1} << (at & 63)) - 1;
  for (; k >= 0 && k < line.words; k += kUp ? 1 : -1) {
    prepare(line, grid, k);
    const std::uint64_t found = stops<kUp>(line, k, before) & ahead;
    if (found != 0) return k * 64 + (kUp ? __builtin_ctzll(found) : 63 - __builtin_clzll(found));
    ahead = ~std::uint64_t{0};
    before = k;
  }
  return -1;
}

/// `goal_at`: the goal's place on the line, -1 where it lies elsewhere or behind.
template <bool kUp>
bool scan_line(const Line& line, const Grid& grid, int along, int move, std::int32_t goal_at, Voxel& found) {
  std::int32_t& at = axis(found, along);
  // Each round passes a voxel for good.
  for (;;) {
    const std::int32_t stop = next_stop<kUp>(line, grid, at);
    if (goal_at >= 0 && (stop < 0 || (kUp ? stop >= goal_at : stop <= goal_at))) {
      at = goal_at;
      return true;
    }
    if (stop < 0 || (line.own[stop >> 6] >> (stop & 63) & 1u) != 0) return false;
    at = stop;
    if (forced_moves(move, free_cells(grid, found)) != 0) return true;
  }
}

/// Along an axis that has no turned copy: voxel by voxel.
bool scan_stepwise(const Grid& grid, const Voxel& goal, const Voxel& from, int move, Voxel& found) {
  const Voxel step = offset(move);
  found = from + step;
  // At most kMaxDimension steps: nothing beyond the grid's face is free.
  while (grid.free(found)) {
    if (same(found, goal) || forced_moves(move, free_cells(grid, found)) != 0) return true;
    found = found + step;
  }
  return false;
}

/// The goal's place along an axis where it lies ahead on the line through `from`; else -1.
std::int32_t goal_ahead(const Voxel& goal, const Voxel& from, int along, bool up) {
  for (int a = 0; a < 3; ++a) {
    if (a != along && axis(goal, a) != axis(from, a)) return -1;
  }
  const std::int32_t at = axis(goal, along);
  return (up ? at > axis(from, along) : at < axis(from, along)) ? at : -1;
}

}  // namespace

void scan_reset(ScanMap& map, const Grid& grid) noexcept {
  turned_reset(map.along_y, grid, 1);
  turned_reset(map.along_z, grid, 2);
}

bool scan_straight(ScanMap& map, const Grid& grid, const Voxel& goal, const Voxel& from, int move,
                   Voxel& found) noexcept {
  const Voxel step = offset(move);
  const int along = step.x != 0 ? 0 : (step.y != 0 ? 1 : 2);
  TurnedLayer& layer = along == 1 ? map.along_y : map.along_z;
  if (along != 0 && layer.words == 0) return scan_stepwise(grid, goal, from, move, found);
  const bool up = axis(step, along) > 0;
  const std::int32_t goal_at = goal_ahead(goal, from, along, up);
  const Line line = along == 0 ? line_along_x(grid, from) : line_turned(layer, grid, from);
  found = from;
  return up ? scan_line<true>(line, grid, along, move, goal_at, found)
            : scan_line<false>(line, grid, along, move, goal_at, found);
}

}  // namespace tern
