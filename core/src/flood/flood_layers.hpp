// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Steps from one layer of cells to the next, a word of 64 cells at a time.
#ifndef TERN_FLOOD_FLOOD_LAYERS_HPP
#define TERN_FLOOD_FLOOD_LAYERS_HPP

#include <cstdint>

#include "base/work.hpp"
#include "flood/flood_lattice.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// The axes along which a step may go.
struct FloodSteps {
  bool x;
  bool y;
  bool z;
};

/// out = the free cells that cells of `in` reach by one step of at most a cell along each axis. A step goes axis by
/// axis through free cells, in both orders of x and y, so it cuts no corner. `scratch` has room for two layers.
void spread_layer(const FloodLattice& lattice, const FloodSteps& steps, const std::uint64_t* free,
                  const std::uint64_t* in, std::uint64_t* out, std::uint64_t* scratch) noexcept;

/// Clears all cells outside [low, high]. The ends may lie outside the lattice.
void keep_box(const FloodLattice& lattice, const Voxel& low, const Voxel& high, std::uint64_t* layer) noexcept;

/// layer &= other. True if a cell is left.
bool keep_common(const FloodLattice& lattice, const std::uint64_t* other, std::uint64_t* layer) noexcept;

/// Operations of all of these together, for each word.
constexpr Operations kLayerWordOperations = 24 * ops::kWord;

}  // namespace tern

#endif
