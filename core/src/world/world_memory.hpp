// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The memory behind the world of one request, which is made in slices.
#ifndef TERN_WORLD_WORLD_MEMORY_HPP
#define TERN_WORLD_WORLD_MEMORY_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "world/solid_layer.hpp"
#include "world/world.hpp"

namespace tern {

/// Needs no initialisation before world_begin, and uses its larger part only for a request with solids.
struct WorldMemory {
  const Grid* grid;  ///< the caller's
  bool has_solids;
  std::int32_t steps;   ///< steps of blocking done: one for all walls, then one a solid
  std::int32_t plane;   ///< the next plane of voxels of the current step
  std::int32_t closed;  ///< the last so many solids are closed, until world_open()
  bool is_anew;         ///< the first step begins with the grid's blocked layer
  Solids solids;
  Grid view;  ///< the caller's grid with `layer` as its blocked layer
  SolidLayer layer;
};

inline World world_of(const WorldMemory& memory) noexcept {
  return memory.has_solids ? World(memory.view, memory.solids) : World(*memory.grid);
}

/// Makes the world of a grid alone, which must outlive it.
void world_begin(WorldMemory& memory, const Grid& grid) noexcept;

/// Makes room for walls and solids, which their readers then add to `solids`.
void begin_solids(WorldMemory& memory) noexcept;

/// Once all are read: gives the world a blocked layer of its own, and thin boundaries in place of walls that leave no
/// whole voxel. The grid must be inflated. kOk, or kWorldFull.
Status world_prepare(WorldMemory& memory) noexcept;

/// After world_prepare: blocks the voxels that walls and solids take. A piece of work is one plane of voxels of a step.
Progress world_advance(WorldMemory& memory, Work& work) noexcept;

}  // namespace tern

#endif
