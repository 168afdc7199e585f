// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/world_memory.hpp"

#include "base/work.hpp"
#include "world/narrow_boundary.hpp"

namespace tern {
namespace {

void copy_plane(WorldMemory& memory, std::int32_t z, Work& work) {
  const Voxel& dims = memory.view.spec().dims;
  const auto rows = static_cast<std::size_t>(dims.y);
  const std::size_t words = static_cast<std::size_t>(memory.view.row_words()) * rows;
  const std::size_t first = words * static_cast<std::size_t>(z);
  const std::uint64_t* const from = GridAccess::blocked(*memory.grid).words + first;
  for (std::size_t k = 0; k < words; ++k) memory.layer.words[first + k] = from[k];
  work.spend(ops::kElement * static_cast<Operations>(words));
}

/// Blocks the voxels of plane z that the current step forbids.
void block_plane(WorldMemory& memory, std::int32_t z, Work& work) {
  if (memory.steps == 0 && memory.is_anew) copy_plane(memory, z, work);
  if (memory.steps == 0) return block_outside(memory.solids, memory.layer, memory.view, z, work);
  const ConvexSolid solid = solid_of(memory.solids, memory.solids.parts[memory.steps - 1]);
  if (z == 0) prepare_solid(solid, memory.layer, memory.view, work);
  block_solid(memory.layer, memory.view, z, work);
}

}  // namespace

void world_begin(WorldMemory& memory, const Grid& grid) noexcept {
  memory.grid = &grid;
  memory.has_solids = false;
}

void begin_solids(WorldMemory& memory) noexcept {
  memory.view = *memory.grid;
  memory.has_solids = true;
  memory.steps = memory.plane = memory.closed = 0;
  memory.is_anew = false;
}

Status world_prepare(WorldMemory& memory) noexcept {
  const Status status = copy_blocked(*memory.grid, memory.layer, memory.view);
  if (status == Status::kOk) memory.layer.narrowed = narrow_boundary(memory.solids, memory.view);
  return status;
}

Progress world_advance(WorldMemory& memory, Work& work) noexcept {
  const std::int32_t planes = memory.view.spec().dims.z;
  for (; memory.steps <= memory.solids.solid_count; ++memory.steps) {
    for (; memory.plane < planes; ++memory.plane) {
      if (!work.left()) return Progress::kMore;
      block_plane(memory, memory.plane, work);
    }
    memory.plane = 0;
  }
  return Progress::kDone;
}

}  // namespace tern
