// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Things that stand for a while, as solids of a world: ways then lead around them as if they always stood there.
#ifndef TERN_WORLD_CLOSED_HPP
#define TERN_WORLD_CLOSED_HPP

#include <cstdint>

#include "tern/grid.hpp"
#include "world/world_memory.hpp"

namespace tern {

/// Makes the keep-out for a while of this index in the request a solid; then world_advance() again. False if none of
/// this index is near the grid, or it is one already.
bool close_fence(WorldMemory& memory, std::int32_t index) noexcept;
/// The same for all keep-outs for a while.
void close_all_fences(WorldMemory& memory) noexcept;
/// The same for a box, world frame; the world may have had no solids. False if it is not near the grid, or does not
/// fit.
bool close_box(WorldMemory& memory, const Box& box) noexcept;
/// The world without all that was closed; then world_advance() again. False if nothing was.
bool open_world(WorldMemory& memory) noexcept;

}  // namespace tern

#endif
