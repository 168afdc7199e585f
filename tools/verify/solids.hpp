// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which voxels are solid, as docs/grid.md and docs/formats.md define it.
#ifndef TERN_VERIFY_SOLIDS_HPP
#define TERN_VERIFY_SOLIDS_HPP

#include <vector>

#include "verify/problem.hpp"

namespace tern_verify {

/// Where the voxels of a scenario lie. World frame.
struct Lattice {
  Point origin;
  Rational cell;
  std::array<long, 3> dims;
};

/// Voxels from `begin` to before `end` on each axis.
struct Cells {
  std::array<long, 3> begin, end;
};

/// Throws InputError where the grid is too large.
Lattice lattice_of(const Problem& problem);

/// The voxels whose interior a block meets; false where it meets none.
bool cells_of(const Box& block, const Lattice& lattice, Cells& cells);

/// All solid voxels: a cuboid of them for each block that meets the grid, and those of map_cells.
std::vector<Cells> solid_cells(const Problem& problem, const Lattice& lattice);

/// The voxels that map files make solid, in cuboids that share none.
std::vector<Cells> map_cells(const Problem& problem, const Lattice& lattice);

/// The boundary, and as far around it as what map files say counts.
Box reach_of(const Problem& problem);

/// True where something of the map files counts, and is not all within the boundary.
bool map_sticks_out(const Problem& problem);

/// The closed cubes of those voxels, together.
Box box_of(const Lattice& lattice, const Cells& cells);

}  // namespace tern_verify

#endif
