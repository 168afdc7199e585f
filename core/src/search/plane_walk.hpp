// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Steps along a plane diagonal. A step leads from p to n = p + u + v. Whether it is legal, and whether it forces a move
// at n, depends on 2 x 2 x 3 voxels: {p, p + u, p + v, n}, and their neighbours on either side of the plane.
#ifndef TERN_SEARCH_PLANE_WALK_HPP
#define TERN_SEARCH_PLANE_WALK_HPP

#include "grid/lattice.hpp"
#include "search/neighbourhood.hpp"

namespace tern {

namespace plane_walk {

/// A row outside the grid, all of it blocked.
struct BlockedRow {
  std::uint64_t words[kMaxRowWords];
};
constexpr BlockedRow make_blocked_row() {
  BlockedRow row{};
  for (std::uint64_t& word : row.words) word = ~std::uint64_t{0};
  return row;
}
inline constexpr BlockedRow kBlockedRow = make_blocked_row();

/// A row of the blocked layer beside the walk. Each step moves it by `stride` words.
struct Row {
  const std::uint64_t* words;
  std::int64_t stride;
};

}  // namespace plane_walk

/// A walk from `at` by `step` in a plane that holds the x axis; kNormal (1 or 2) is the axis at right angles to the
/// plane. No step may leave the grid.
template <int kNormal>
class PlaneWalk {
 public:
  PlaneWalk(const Grid& grid, const Voxel& at, const Voxel& step) noexcept : step_x_(step.x), x_(at.x) {
    const BitRows blocked = GridAccess::blocked(grid);
    words_ = blocked.row_words;
    const std::int64_t stride = kNormal == 1 ? blocked.index(0, step.z) : blocked.index(step.y, 0);
    for (int k = 0; k < 3; ++k) {
      Voxel v = at;
      axis(v, kNormal) += k - 1;
      rows_[k] = {plane_walk::kBlockedRow.words, 0};
      if (axis(v, kNormal) >= 0 && axis(v, kNormal) < axis(grid.spec().dims, kNormal))
        rows_[k] = {blocked.row(v.y, v.z), stride};
    }
    cells_ = slab();
  }

  /// Makes one step; false if it cuts a corner or meets an obstacle.
  bool step() noexcept {
    x_ += step_x_;
    for (plane_walk::Row& row : rows_) row.words += row.stride;
    const CellMask p = cells_ >> 1;
    const CellMask u = cells_ >> (1 + step_x_);
    cells_ = slab();
    const CellMask n = cells_ >> 1;
    const CellMask v = cells_ >> (1 - step_x_);
    forced_ = ((p | u | v) & ~n & kBesidePlane) != 0;
    return ((n | u | v) & kInPlane) == 0;
  }
  /// True if the last step forces a move. It does if, on one side of the plane, a voxel beside p, p + u or p + v is
  /// blocked and the voxel beside n is free.
  bool forced() const noexcept { return forced_; }

 private:
  static constexpr CellMask kInPlane = 1u << 3;
  static constexpr CellMask kBesidePlane = 1u | 1u << 6;

  /// Blocked cells, x - 1 .. x + 1 fastest, then the three levels along the normal.
  CellMask slab() const noexcept {
    return blocked_triple(rows_[0].words, words_, x_) | blocked_triple(rows_[1].words, words_, x_) << 3 |
           blocked_triple(rows_[2].words, words_, x_) << 6;
  }

  std::int32_t step_x_;
  std::int32_t x_;
  std::int32_t words_;
  plane_walk::Row rows_[3];
  CellMask cells_;
  bool forced_ = false;
};

/// A walk in a plane of constant x.
template <>
class PlaneWalk<0> {
 public:
  PlaneWalk(const Grid& grid, const Voxel& at, const Voxel& step) noexcept
      : row_(grid.blocked_row(at.y, at.z)),
        words_(grid.row_words()),
        x_(at.x),
        step_y_(GridAccess::blocked(grid).index(step.y, 0)),
        step_z_(GridAccess::blocked(grid).index(0, step.z)),
        cells_(blocked_triple(row_, words_, x_)) {}

  bool step() noexcept {
    const CellMask p = cells_;
    const CellMask u = blocked_triple(row_ + step_y_, words_, x_);
    const CellMask v = blocked_triple(row_ + step_z_, words_, x_);
    row_ += step_y_ + step_z_;
    const CellMask n = cells_ = blocked_triple(row_, words_, x_);
    forced_ = ((p | u | v) & ~n & kBesidePlane) != 0;
    return ((n | u | v) & kInPlane) == 0;
  }
  bool forced() const noexcept { return forced_; }

 private:
  static constexpr CellMask kInPlane = 1u << 1;
  static constexpr CellMask kBesidePlane = 1u | 1u << 2;

  const std::uint64_t* row_;
  std::int32_t words_;
  std::int32_t x_;
  std::int64_t step_y_;
  std::int64_t step_z_;
  CellMask cells_;
  bool forced_ = false;
};

}  // namespace tern

#endif
