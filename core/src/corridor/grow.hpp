// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The polyhedron of one segment (the paper's Section 3.3.1): a box around the segment, the obstacles in it as solid
// boxes, an ellipsoid fitted between them, and half-spaces that cut them off, the nearest in the ellipsoid's metric
// first. Every obstacle voxel of the whole grid ends up beyond one half-space by the grid's radius.
#ifndef TERN_CORRIDOR_GROW_HPP
#define TERN_CORRIDOR_GROW_HPP

#include <cstdint>

#include "corridor/grow_scratch.hpp"
#include "corridor/improve.hpp"
#include "tern/corridor.hpp"
#include "tern/grid.hpp"
#include "tern/status.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// How far the local box reaches beyond the segment, metres, and in voxels at least. Where its obstacles or half-spaces
/// do not fit their capacity it is halved, kBoxLevels sizes in all.
constexpr double kLocalMargin = 2.0;
constexpr double kLocalMarginCells = 4.0;
constexpr int kBoxLevels = 6;

/// Half-spaces that one call may make: each size of the local box begins anew, each round and each
/// trial after the box's faces.
constexpr std::uint32_t kGrowBound =
    static_cast<std::uint32_t>(kBoxLevels * (1 + kImprovingRounds + kLeaveOuts) * kMaxPlanes);

/// Grows the polyhedron of the segment `from`, `to` (local frame, metres; may be a point), which must keep the radius
/// from every obstacle and lie in the boundary.
///
/// kOk: `out` holds the segment; each of its half-spaces keeps min(kSightMargin * cell, the room there is) from it;
/// each obstacle voxel is beyond one half-space by the radius (to 1e-9 m); the ellipsoid lies inside all half-spaces.
/// kOutOfMap: an end outside the boundary. kCorridorBlocked: an obstacle nearer than the radius to the segment.
/// kObstaclesFull, kPlanesFull: even the smallest local box has too many; a shorter segment may do. kBudgetCorridor.
/// `out` is undefined after anything but kOk.
Status grow_polyhedron(const Grid& grid, const Vec3& from, const Vec3& to, GrowScratch& scratch,
                       Polyhedron& out) noexcept;

}  // namespace tern

#endif
