// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Walls and solids as blocked voxels, for the search. Each query has a blocked layer of its own, so the caller's grid
// does not change.
#ifndef TERN_WORLD_SOLID_LAYER_HPP
#define TERN_WORLD_SOLID_LAYER_HPP

#include <cstdint>

#include "base/work.hpp"
#include "grid/lattice.hpp"
#include "tern/grid.hpp"
#include "tern/status.hpp"
#include "world/solids.hpp"

namespace tern {

/// Normals tried for one solid: the axes, the normals of its faces, and the directions half way between two of these.
constexpr int kMaxSolidNormals = 6 + kMaxSolidFaces + kMaxSolidFaces * (kMaxSolidFaces - 1) / 2;

/// Room for a blocked layer, and scratch. Plain data.
struct SolidLayer {
  std::uint64_t words[kMaxWorldWords];
  bool narrowed;  ///< by narrow_boundary(): the view's boundary is not the grid's
  std::int32_t clear_count;
  Halfspace clear[kMaxSolidNormals];  ///< points with normal . p >= offset are clear of the current solid
  IndexRange planes;                  ///< planes that the current solid reaches
  IndexRange rows;                    ///< rows that the current solid reaches
};

/// Makes `view` a view of the inflated `grid` whose blocked layer is a copy in `layer`. kOk, or kWorldFull.
Status copy_blocked(const Grid& grid, SolidLayer& layer, Grid& view) noexcept;

/// Blocks each voxel in plane z of the view whose closed cube is not inside all walls. In a view that was narrowed,
/// first makes the plane anew within its boundary. A piece of work.
void block_outside(const Solids& solids, SolidLayer& layer, const Grid& view, std::int32_t z, Work& work) noexcept;

/// Blocks the voxels that the solid, grown by the radius, may reach: prepare_solid() once, then plane by plane. A voxel
/// stays free if one plane cuts it off with the radius to spare. The normals of these planes are the coordinate axes,
/// the normals of the faces, and the directions half way between two of these. The latter are needed because the grown
/// solid is round at its edges. At a corner, a voxel too many may be blocked, but never one too few. A plane is a piece
/// of work.
void prepare_solid(const ConvexSolid& solid, SolidLayer& layer, const Grid& view, Work& work) noexcept;
void block_solid(SolidLayer& layer, const Grid& view, std::int32_t z, Work& work) noexcept;

/// The most operations to make a plane anew within a boundary.
Operations solid_plane_operations(const GridSpec& spec) noexcept;

}  // namespace tern

#endif
