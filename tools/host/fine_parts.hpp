// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A coarse grid of a world that is too large for one fine grid.
#ifndef TERN_HOST_FINE_PARTS_HPP
#define TERN_HOST_FINE_PARTS_HPP

#include <functional>

#include "tern/grid.hpp"

namespace tern_host {

/// Marks what fine voxels close in a coarse grid, part by part, and inflates it. `mark` gets a fine grid of radius 0,
/// which holds a part of the coarse grid's box, and marks in it what the world has there. If the coarse boundary holds
/// no whole cell on an axis, a cell's fine voxels are mostly outside of it: then `mark` gets the coarse grid itself.
/// Throws std::runtime_error if a quarter of the coarse cell is no voxel's edge.
void mark_from_fine(tern::Grid& coarse, const std::function<void(tern::Grid&)>& mark);

}  // namespace tern_host

#endif
