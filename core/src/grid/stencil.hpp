// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_GRID_STENCIL_HPP
#define TERN_GRID_STENCIL_HPP

#include <cstdint>

#include "base/work.hpp"
#include "tern/grid.hpp"

namespace tern {

/// The ball that inflation spreads each obstacle by, in exact integers. A voxel is blocked if the squared gap between
/// its cube and an obstacle's, in cells, is below (radius / cell)^2. The gap on one axis is |difference of indices| -
/// 1, or 0 for equal indices.
class Stencil {
 public:
  explicit Stencil(const GridSpec& spec);

  /// Largest gaps along x and z that matter in a grid of these dimensions; -1 for radius 0, with which obstacles block
  /// only themselves.
  std::int32_t gap_x() const { return gap_x_; }
  std::int32_t gap_z() const { return gap_z_; }

  /// Largest |dy| of a row whose obstacles block voxels that are gap_z away along z and gap_x along x, dims.y - 1 at
  /// most; -1 for none. 0 <= gap_z <= gap_z(), 0 <= gap_x <= gap_x().
  std::int32_t reach(std::int32_t gap_z, std::int32_t gap_x) const {
    return gap_z < kTable && gap_x < kTable ? table_[gap_z][gap_x] : compute(gap_z, gap_x);
  }

 private:
  static constexpr std::int32_t kTable = 16;  // a larger ball costs enough that a root for each row does not matter

  std::int32_t compute(std::int32_t gap_z, std::int32_t gap_x) const;

  std::int32_t limit_;  // largest squared gap that blocks
  std::int32_t gap_x_;
  std::int32_t gap_z_;
  std::int32_t last_row_;
  std::int16_t table_[kTable][kTable];
};

/// Operations of making a stencil: a root for each entry of its table.
constexpr Operations kStencilOperations = 16 * 16 * 4 * ops::kTurn;

}  // namespace tern

#endif
