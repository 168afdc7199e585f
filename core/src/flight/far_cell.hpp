// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A cell of a coarse grid against what a rolling map saw.
#ifndef TERN_FLIGHT_FAR_CELL_HPP
#define TERN_FLIGHT_FAR_CELL_HPP

#include "base/work.hpp"
#include "grid/bit_rows.hpp"
#include "tern/grid.hpp"
#include "tern/map.hpp"

namespace tern {

/// True if there is a near grid to read: not while the map's window slides.
inline bool has_grid(const RollingMap& map) noexcept {
  return map.bound() && map.route().bound();
}

/// True if the near grid has an obstacle whose voxel's centre is in the cell of the coarse grid, and the coarse grid
/// does not explain it: voxels next to a marked cell, or to the coarse grid's rim, show what is marked there, off by
/// the errors of a sensor. Both grids must be bound.
bool shows_more(const Grid& coarse, const Grid& near, const Voxel& cell, Work& work) noexcept;

/// The cells of the coarse grid on one axis that the near grid meets.
IndexRange cells_met(const Grid& coarse, const Grid& near, int a) noexcept;

/// If the cell that holds `place` (world frame) is not free: finds the centre of the nearest free cell, of those up to
/// three cells away to which the near grid shows no obstacle on the straight line. So nobody begins behind a wall that
/// he is in front of. Of equally near ones, the first along z, then y, then x. False if there is none. Both grids must
/// be bound.
bool find_open_cell(const Grid& coarse, const Grid& near, const Vec3& place, Vec3& found, Work& work) noexcept;

}  // namespace tern

#endif
