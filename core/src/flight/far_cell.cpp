// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/far_cell.hpp"

#include "base/math.hpp"
#include "grid/lattice.hpp"
#include "path/sight.hpp"

namespace tern {
namespace {

/// Near voxels next to a marked cell that the coarse grid explains.
constexpr std::int32_t kExplained = 2;
/// Cells around the vehicle that are looked at for a free one, along each axis and direction.
constexpr std::int32_t kOpenAway = 3;
/// Parts of a cell along an axis: its first kExplained near voxels, the middle, and its last ones.
constexpr int kParts = 3;

/// The near voxels on one axis whose centres are in the cell, in three parts.
struct CellParts {
  IndexRange all;
  IndexRange part[kParts];

  int part_of(std::int32_t voxel) const { return contains(part[0], voxel) ? 0 : (contains(part[2], voxel) ? 2 : 1); }
};

CellParts parts_of(const Grid& coarse, const Grid& near, const Voxel& cell, int a) {
  const GridSpec& fine = near.spec();
  const double edge = coarse.spec().cell / fine.cell;
  const double lower = (axis(coarse.spec().origin, a) - axis(fine.origin, a)) / fine.cell + edge * axis(cell, a) - 0.5;
  const std::int32_t count = axis(fine.dims, a);
  const IndexRange all{ceil_index(lower, 0, count), ceil_index(lower + edge, 0, count)};
  const std::int32_t first = ceil_index(lower + kExplained, all.begin, all.end);
  const std::int32_t last = ceil_index(lower + edge - kExplained, first, all.end);
  return {all, {{all.begin, first}, {first, last}, {last, all.end}}};
}

int index_of(int x, int y, int z) {
  return x + kParts * (y + kParts * z);
}

/// Which of the 27 parts of a cell the coarse grid explains: those that touch a marked cell, or the outside.
class Explained {
 public:
  Explained(const Grid& coarse, const Voxel& cell) {
    for (int z = 0; z < kParts; ++z) {
      for (int y = 0; y < kParts; ++y) {
        for (int x = 0; x < kParts; ++x) closed_[index_of(x, y, z)] = is_closed(coarse, cell, {x - 1, y - 1, z - 1});
      }
    }
  }
  bool part(int x, int y, int z) const {
    bool touches = false;
    for (int way = 1; way < 8; ++way) {
      touches = touches || closed_[index_of((way & 1) != 0 ? x : 1, (way & 2) != 0 ? y : 1, (way & 4) != 0 ? z : 1)];
    }
    return touches;
  }

 private:
  static bool is_closed(const Grid& coarse, const Voxel& cell, const Voxel& step) {
    const Voxel beside{cell.x + step.x, cell.y + step.y, cell.z + step.z};
    const bool is_cell = step.x == 0 && step.y == 0 && step.z == 0;
    return !is_cell && (!coarse.inside(beside) || coarse.obstacle(beside));
  }

  bool closed_[kParts * kParts * kParts];
};

bool has_obstacle(const std::uint64_t* row, const IndexRange& x) {
  if (x.begin >= x.end) return false;
  std::uint64_t found = 0;
  for (std::int32_t w = x.begin >> 6; w <= (x.end - 1) >> 6; ++w) found |= row[w] & bits_within(x, w);
  return found != 0;
}

}  // namespace

bool shows_more(const Grid& coarse, const Grid& near, const Voxel& cell, Work& work) noexcept {
  const CellParts x = parts_of(coarse, near, cell, 0);
  const CellParts y = parts_of(coarse, near, cell, 1);
  const CellParts z = parts_of(coarse, near, cell, 2);
  const Explained explained(coarse, cell);
  bool found = false;
  for (std::int32_t k = z.all.begin; k < z.all.end; ++k) {
    for (std::int32_t j = y.all.begin; j < y.all.end; ++j) {
      const std::uint64_t* const row = near.obstacle_row(j, k);
      for (int part = 0; part < kParts && has_obstacle(row, x.all); ++part) {
        found = found || (!explained.part(part, y.part_of(j), z.part_of(k)) && has_obstacle(row, x.part[part]));
      }
    }
  }
  const Operations rows = static_cast<Operations>(y.all.end - y.all.begin) * (z.all.end - z.all.begin);
  const Operations words = ((x.all.end - x.all.begin) >> 6) + 2;
  work.spend(2 * ops::kPiece + rows * (ops::kRow + ops::kWord * words));
  return found;
}

IndexRange cells_met(const Grid& coarse, const Grid& near, int a) noexcept {
  const double cell = coarse.spec().cell;
  const double lower = axis(near.spec().origin, a) - axis(coarse.spec().origin, a);
  const double upper = lower + near.spec().cell * axis(near.spec().dims, a);
  const std::int32_t count = axis(coarse.spec().dims, a);
  return {floor_index(lower / cell, 0, count), ceil_index(upper / cell, 0, count)};
}

bool find_open_cell(const Grid& coarse, const Grid& near, const Vec3& place, Vec3& found, Work& work) noexcept {
  const Grid bare = GridAccess::bare(near);
  const Vec3 from = near.to_local(place);
  const Voxel here = coarse.voxel_of(coarse.to_local(place));
  double least = -1.0;
  for (std::int32_t z = here.z - kOpenAway; z <= here.z + kOpenAway; ++z) {
    for (std::int32_t y = here.y - kOpenAway; y <= here.y + kOpenAway; ++y) {
      for (std::int32_t x = here.x - kOpenAway; x <= here.x + kOpenAway; ++x) {
        const Vec3 centre = coarse.spec().origin + free_point(coarse, {x, y, z});
        const double away = distance(centre, place);
        work.spend(ops::kTurn);
        if (!coarse.free({x, y, z}) || (least >= 0.0 && away >= least)) continue;
        const Vec3 to = near.to_local(centre);
        work.spend(sight_operations(near, from, to));
        if (!line_of_sight(bare, from, to, 0.0)) continue;
        least = away;
        found = centre;
      }
    }
  }
  return least >= 0.0;
}

}  // namespace tern
