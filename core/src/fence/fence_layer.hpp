// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fences as voxels that are not free, for the search: in a blocked layer of the query's own, so that the caller's grid
// stays as it is.
#ifndef TERN_FENCE_FENCE_LAYER_HPP
#define TERN_FENCE_FENCE_LAYER_HPP

#include <cstdint>

#include "fence/fences.hpp"
#include "tern/grid.hpp"
#include "tern/status.hpp"

namespace tern {

/// Normals tried for one keep-out: axes, faces, and half way between two faces'.
constexpr int kMaxFenceNormals = 6 + kMaxFencePlanes + kMaxFencePlanes * (kMaxFencePlanes - 1) / 2;

/// Room for a blocked layer, and scratch. Plain data.
struct FenceLayer {
  std::uint64_t words[kMaxFenceWords];
  std::int32_t clear_count;
  Halfspace clear[kMaxFenceNormals];  ///< normal . p >= offset is clear of the keep-out at hand
};

/// Makes `view` a view of the inflated `grid` whose blocked layer is a copy in `layer`. kOk, or kFenceLayerFull.
Status copy_blocked(const Grid& grid, FenceLayer& layer, Grid& view) noexcept;

/// Blocks each voxel of the view whose closed cube is not in each keep-in. One pass over the rows.
void block_outside(const Fences& fences, FenceLayer& layer, const Grid& view) noexcept;

/// Blocks the voxels that the keep-out, grown by the radius, may reach: all but those that some plane cuts off with the
/// radius to spare whose normal is a coordinate axis, that of a face, or half way between two faces' (as a ball about
/// an edge is rounder than the faces' planes show). A voxel too many at a corner, never one too few.
void block_keep_out(const Fences& fences, const KeepOut& fence, FenceLayer& layer, const Grid& view) noexcept;

}  // namespace tern

#endif
