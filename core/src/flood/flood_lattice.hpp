// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The cells of the flood in time: cubes of voxels, a bit each. A cell is free if all its voxels are.
#ifndef TERN_FLOOD_FLOOD_LATTICE_HPP
#define TERN_FLOOD_FLOOD_LATTICE_HPP

#include <cstdint>

#include "base/math.hpp"
#include "base/work.hpp"
#include "tern/grid.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Geometry, in the grid's local frame. Cell x of a row is bit x % 64 of its word x / 64; rows follow one another along
/// y, and planes along z.
struct FloodLattice {
  Voxel low;          ///< the lowest voxel of cell (0, 0, 0)
  std::int32_t edge;  ///< voxels along a cell's edge; fewer on an axis along which the boundary holds fewer
  Voxel cells;        ///< how many there are along each axis
  std::int32_t row_words;
  std::int32_t words;  ///< of a layer
  double size;         ///< edge of a cell, m

  std::int32_t row(std::int32_t y, std::int32_t z) const noexcept { return (z * cells.y + y) * row_words; }
};

/// Lays the lattice out over the boundary, so that `middle` is about in the middle of a cell.
FloodLattice lay_out(const Grid& grid, const Vec3& middle, std::int32_t edge) noexcept;

/// Keeps the cells that a way from one point to another can pass with so many steps along each axis. They stay where
/// they are.
void keep_cells_between(const Grid& grid, const Vec3& from, const Vec3& to, const Voxel& steps,
                        FloodLattice& lattice) noexcept;

/// The cell that holds a point, or the nearest one.
Voxel cell_at(const FloodLattice& lattice, const Grid& grid, const Vec3& point) noexcept;

/// The middle of a cell, within the boundary.
Vec3 middle_of(const FloodLattice& lattice, const Grid& grid, const Voxel& cell) noexcept;

/// Fills the row (y, z) of the layer of free cells. Returns the operations that it took.
Operations fill_free_row(const FloodLattice& lattice, const Grid& grid, std::int32_t y, std::int32_t z,
                         std::uint64_t* layer) noexcept;

inline bool has_cell(const FloodLattice& lattice, const std::uint64_t* layer, const Voxel& cell) noexcept {
  return (layer[lattice.row(cell.y, cell.z) + (cell.x >> 6)] >> (cell.x & 63) & 1u) != 0;
}
inline void set_cell(const FloodLattice& lattice, const Voxel& cell, std::uint64_t* layer) noexcept {
  layer[lattice.row(cell.y, cell.z) + (cell.x >> 6)] |= std::uint64_t{1} << (cell.x & 63);
}
inline bool is_cell(const FloodLattice& lattice, const Voxel& cell) noexcept {
  return cell.x >= 0 && cell.y >= 0 && cell.z >= 0 && cell.x < lattice.cells.x && cell.y < lattice.cells.y &&
         cell.z < lattice.cells.z;
}

}  // namespace tern

#endif
