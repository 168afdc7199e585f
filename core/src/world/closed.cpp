// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/closed.hpp"

#include "base/capacity.hpp"
#include "world/fences.hpp"

namespace tern {
namespace {

/// A world that had no solids gets a layer of its own, which its first step fills.
bool has_layer(WorldMemory& memory) {
  if (memory.has_solids) return true;
  const std::size_t words = GridAccess::layer_words(*memory.grid);
  if (is_full(words > static_cast<std::size_t>(kMaxWorldWords))) return false;
  begin_solids(memory);
  clear_solids(memory.solids);
  memory.view = GridAccess::with_blocked(*memory.grid, memory.layer.words);
  memory.layer.narrowed = false;
  memory.is_anew = true;
  return true;
}

}  // namespace

bool close_fence(WorldMemory& memory, std::int32_t index) noexcept {
  Solids& solids = memory.solids;
  for (std::int32_t k = 0; memory.has_solids && k < solids.timed_count; ++k) {
    SolidParts& parts = solids.parts[solids.solid_count + k];
    if (parts.index != index) continue;
    const SolidParts closed = parts;
    parts = solids.parts[solids.solid_count];
    solids.parts[solids.solid_count++] = closed;
    --solids.timed_count;
    ++memory.closed;
    return true;
  }
  return false;
}

void close_all_fences(WorldMemory& memory) noexcept {
  if (!memory.has_solids) return;
  Solids& solids = memory.solids;
  solids.solid_count += solids.timed_count;
  memory.closed += solids.timed_count;
  solids.timed_count = 0;
}

bool close_box(WorldMemory& memory, const Box& box) noexcept {
  return has_layer(memory) && add_timed_box(*memory.grid, box, memory.solids) && close_fence(memory, kNoSolid);
}

bool open_world(WorldMemory& memory) noexcept {
  if (!memory.has_solids || memory.closed == 0) return false;
  Solids& solids = memory.solids;
  const std::int32_t end = solids.solid_count + solids.timed_count;
  solids.solid_count -= memory.closed;
  solids.timed_count = 0;
  for (std::int32_t k = solids.solid_count; k < end; ++k) {
    if (solids.parts[k].index != kNoSolid) solids.parts[solids.solid_count + solids.timed_count++] = solids.parts[k];
  }
  memory.steps = memory.plane = memory.closed = 0;
  memory.is_anew = true;
  return true;
}

}  // namespace tern
