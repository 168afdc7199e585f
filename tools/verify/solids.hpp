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

Lattice lattice_of(const Problem& problem);

/// The voxels that the blocks make solid: one cuboid of them for each block that meets the grid.
std::vector<Cells> solid_cells(const Problem& problem, const Lattice& lattice);

/// The closed cubes of those voxels, together.
Box box_of(const Lattice& lattice, const Cells& cells);

}  // namespace tern_verify

#endif
