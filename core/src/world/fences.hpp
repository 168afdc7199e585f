// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A request's geofences as walls and solids.
#ifndef TERN_WORLD_FENCES_HPP
#define TERN_WORLD_FENCES_HPP

#include <cstdint>

#include "base/fence_fault.hpp"
#include "tern/fence.hpp"
#include "tern/grid.hpp"
#include "world/solids.hpp"
#include "world/world_memory.hpp"

namespace tern {

/// Reads `count` fences (world frame) for planning on `grid`. Keep-ins become walls and keep-outs become solids. A
/// keep-out without a part that matters is left out. kOk; what find_fence_fault() says; kFencePlanesFull if the corners
/// of a keep-out do not fit. `solids` is undefined unless kOk.
FenceFault load_fences(const Grid& grid, const Fence* list, std::int32_t count, Solids& solids) noexcept;

void clear_solids(Solids& solids) noexcept;

/// Adds a box, world frame, behind the solids of fences for a while; its index is kNoSolid. False if it is not near the
/// grid, or does not fit.
bool add_timed_box(const Grid& grid, const Box& box, Solids& solids) noexcept;

/// Adds fences to a world, which reads them only now. The answers are those of load_fences; the world is undefined
/// unless kOk.
FenceFault world_add(WorldMemory& memory, const Fence* list, std::int32_t count) noexcept;

}  // namespace tern

#endif
