// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/solids.hpp"

#include <algorithm>

namespace tern_verify {
namespace {

bool sticks_out(const Box& block, const Box& boundary) {
  for (std::size_t a = 0; a < 3; ++a) {
    if (block.lower[a] < boundary.lower[a] || block.upper[a] > boundary.upper[a]) return true;
  }
  return false;
}

/// Part of a voxel by which a face may miss a lattice plane and count as on it: 1e-9, and the rounding of the number.
Rational face_tolerance(const Rational& world, const Rational& cell) {
  return decimal(1, 9) + abs(world) * ulp() / cell;
}

/// A number as an index; all beyond the grid are alike.
long index_of(const Integer& number, long count) {
  if (number < -1) return -1;
  return number > count + 1 ? count + 1 : static_cast<long>(number);
}

struct Range {
  long begin, end;
};

/// The voxels of one axis whose interior a block meets. A flat block on a lattice plane has the voxels above it; on the
/// grid's upper face, those below it.
Range range_of(const Box& block, const Lattice& lattice, std::size_t a) {
  const Rational lower = (block.lower[a] - lattice.origin[a]) / lattice.cell;
  const Rational upper = (block.upper[a] - lattice.origin[a]) / lattice.cell;
  const long count = lattice.dims[a];
  long begin = index_of(floor_of(lower + face_tolerance(block.lower[a], lattice.cell)), count);
  long end = index_of(ceil_of(upper - face_tolerance(block.upper[a], lattice.cell)), count);
  if (end <= begin) {
    if (begin == count) --begin;
    end = begin + 1;
  }
  return {std::max(begin, 0L), std::min(end, count)};
}

}  // namespace

Lattice lattice_of(const Problem& problem) {
  const auto beyond = [&](const Box& block) { return sticks_out(block, problem.boundary); };
  const bool padded = problem.unknown_is_solid || map_sticks_out(problem) ||
                      std::any_of(problem.blocks.begin(), problem.blocks.end(), beyond);
  const Integer padding = padded ? Integer(ceil_of(problem.clearance / problem.cell) + 1) : Integer(0);
  Lattice lattice{{}, problem.cell, {}};
  for (std::size_t a = 0; a < 3; ++a) {
    const Rational extent = problem.boundary.upper[a] - problem.boundary.lower[a];
    const Integer count = ceil_of(extent / problem.cell - decimal(1, 9)) + 2 * padding;
    lattice.origin[a] = problem.boundary.lower[a] - Rational(padding) * problem.cell;
    if (count > 1000000) throw InputError(problem.name + ": the grid has more than a million voxels along an axis");
    lattice.dims[a] = std::max(1L, static_cast<long>(count));
  }
  return lattice;
}

bool cells_of(const Box& block, const Lattice& lattice, Cells& cells) {
  bool meets = true;
  for (std::size_t a = 0; a < 3; ++a) {
    const Range range = range_of(block, lattice, a);
    cells.begin[a] = range.begin;
    cells.end[a] = range.end;
    meets = meets && range.begin < range.end;
  }
  return meets;
}

std::vector<Cells> solid_cells(const Problem& problem, const Lattice& lattice) {
  std::vector<Cells> solid = map_cells(problem, lattice);
  Cells cells{};
  for (const Box& block : problem.blocks) {
    if (cells_of(block, lattice, cells)) solid.push_back(cells);
  }
  return solid;
}

Box box_of(const Lattice& lattice, const Cells& cells) {
  Box box;
  for (std::size_t a = 0; a < 3; ++a) {
    box.lower[a] = lattice.origin[a] + cells.begin[a] * lattice.cell;
    box.upper[a] = lattice.origin[a] + cells.end[a] * lattice.cell;
  }
  return box;
}

}  // namespace tern_verify
