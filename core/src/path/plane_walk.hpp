// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Steps along a plane diagonal. Whether a step from p to n = p + u + v is legal, and whether it forces a move at n,
// both show in the 2 x 2 x 3 voxels around the step: {p, p + u, p + v, n}, with those on either side of the plane.
#ifndef TERN_PATH_PLANE_WALK_HPP
#define TERN_PATH_PLANE_WALK_HPP

#include "grid/lattice.hpp"
#include "path/neighbourhood.hpp"

namespace tern {

/// A walk in a plane that holds the x axis; kNormal (1 or 2) is the axis that leaves the plane.
template <int kNormal>
class PlaneWalk {
 public:
  PlaneWalk(const Grid& grid, const Voxel& at) noexcept : cells_(slab(grid, at)) {}

  /// Steps to `to`, a voxel inside the grid; false where that cuts a corner or meets an obstacle.
  bool step(const Grid& grid, const Voxel& to, const Voxel& step) noexcept {
    const CellMask p = cells_ >> 1;
    const CellMask u = cells_ >> (1 + step.x);
    cells_ = slab(grid, to);
    const CellMask n = cells_ >> 1;
    const CellMask v = cells_ >> (1 - step.x);
    forced_ = ((p | u | v) & ~n & kBesidePlane) != 0;
    return ((n | u | v) & kInPlane) == 0;
  }
  /// True where the last step forces a move: something beside it is blocked, and what is beside n is not.
  bool forced() const noexcept { return forced_; }

 private:
  static constexpr CellMask kInPlane = 1u << 3;
  static constexpr CellMask kBesidePlane = 1u | 1u << 6;

  /// Blocked cells, x - 1 .. x + 1 fastest, then the three levels along the normal.
  static CellMask slab(const Grid& grid, const Voxel& v) noexcept {
    constexpr int kY = kNormal == 1 ? 1 : 0;
    constexpr int kZ = kNormal == 2 ? 1 : 0;
    return triple_at(grid, v.x, v.y - kY, v.z - kZ) | triple_at(grid, v.x, v.y, v.z) << 3 |
           triple_at(grid, v.x, v.y + kY, v.z + kZ) << 6;
  }

  CellMask cells_;
  bool forced_ = false;
};

/// A walk in a plane of constant x.
template <>
class PlaneWalk<0> {
 public:
  PlaneWalk(const Grid& grid, const Voxel& at) noexcept : cells_(triple_at(grid, at.x, at.y, at.z)) {}

  bool step(const Grid& grid, const Voxel& to, const Voxel& step) noexcept {
    const CellMask p = cells_;
    const CellMask u = triple_at(grid, to.x, to.y, to.z - step.z);
    const CellMask v = triple_at(grid, to.x, to.y - step.y, to.z);
    const CellMask n = cells_ = triple_at(grid, to.x, to.y, to.z);
    forced_ = ((p | u | v) & ~n & kBesidePlane) != 0;
    return ((n | u | v) & kInPlane) == 0;
  }
  bool forced() const noexcept { return forced_; }

 private:
  static constexpr CellMask kInPlane = 1u << 1;
  static constexpr CellMask kBesidePlane = 1u | 1u << 2;

  CellMask cells_;
  bool forced_ = false;
};

}  // namespace tern

#endif
