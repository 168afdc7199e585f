// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fences as blocked voxels, for the search. Each query has a blocked layer of its own, so the caller's grid does not
// change.
#ifndef TERN_FENCE_FENCE_LAYER_HPP
#define TERN_FENCE_FENCE_LAYER_HPP

#include <cstdint>

#include "fence/fences.hpp"
#include "grid/lattice.hpp"
#include "tern/grid.hpp"
#include "tern/status.hpp"

namespace tern {

/// Normals tried for one keep-out: the axes, the normals of its faces, and the directions half way between two of
/// these.
constexpr int kMaxFenceNormals = 6 + kMaxFencePlanes + kMaxFencePlanes * (kMaxFencePlanes - 1) / 2;

/// Room for a blocked layer, and scratch. Plain data.
struct FenceLayer {
  std::uint64_t words[kMaxFenceWords];
  bool narrowed;  ///< by narrow_boundary(): the view's boundary is not the grid's
  std::int32_t clear_count;
  Halfspace clear[kMaxFenceNormals];  ///< points with normal . p >= offset are clear of the current keep-out
  IndexRange planes;                  ///< planes that the current keep-out reaches
  IndexRange rows;                    ///< rows that the current keep-out reaches
};

/// Makes `view` a view of the inflated `grid` whose blocked layer is a copy in `layer`. kOk, or kFenceLayerFull.
Status copy_blocked(const Grid& grid, FenceLayer& layer, Grid& view) noexcept;

/// Blocks each voxel in plane z of the view whose closed cube is not inside every keep-in. In a view that was narrowed,
/// first makes the plane anew within its boundary. Returns the instructions that it took (see Work).
std::uint32_t block_outside(const Fences& fences, FenceLayer& layer, const Grid& view, std::int32_t z) noexcept;

/// Blocks the voxels that the keep-out, grown by the radius, may reach: prepare_keep_out() once, then plane by plane. A
/// voxel stays free if one plane cuts it off with the radius to spare. The normals of these planes are the coordinate
/// axes, the normals of the faces, and the directions half way between two of these. The latter are needed because the
/// grown keep-out is round at its edges. At a corner, a voxel too many may be blocked, but never one too few. Both
/// functions return the instructions that they took.
std::uint32_t prepare_keep_out(const Fences& fences, const KeepOut& fence, FenceLayer& layer,
                               const Grid& view) noexcept;
std::uint32_t block_keep_out(FenceLayer& layer, const Grid& view, std::int32_t z) noexcept;

}  // namespace tern

#endif
