// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How the exact start or goal reaches the grid.
#ifndef TERN_PATH_JOIN_HPP
#define TERN_PATH_JOIN_HPP

#include <cstdint>

#include "fence/fences.hpp"
#include "tern/grid.hpp"

namespace tern {

/// Free voxels whose centres a point may join are at most so many voxels away from its own on every axis.
constexpr int kJoinReach = 2;
constexpr int kJoinWidth = 2 * kJoinReach + 1;
constexpr int kJoinCells = kJoinWidth * kJoinWidth * kJoinWidth;
constexpr int kMaxJoins = kJoinCells - 1;

enum class JoinState : std::uint8_t {
  kJoined,   ///< `voxel` is free, and the straight line from the point to its centre is clear
  kTrying,   ///< candidates are left
  kRefused,  ///< the point is too close to an obstacle, or no line to a free voxel near it is clear
};

/// One end of the query on its way to the grid. Plain data; needs no initialisation before join_begin.
struct Join {
  JoinState state;
  Voxel voxel;
  Voxel home;  ///< the point's own
  std::int32_t count;
  std::int32_t next;
  Voxel candidates[kMaxJoins];  ///< free voxels, nearest centre first, then least z, y, x
  bool searched[kJoinCells];    ///< around home, x fastest: from here a search found no way
};

/// A point in a free voxel is joined at once. A point whose voxel is not free, but that keeps the radius itself, has
/// the free voxels around it as candidates.
void join_begin(Join& join, const Grid& grid, const Vec3& point) noexcept;

/// The search from `voxel` found no way: it may lie in a pocket that is cut off. What the voxel is joined to by faces
/// within the candidates' reach is not tried again. False where no candidate is left. Where the point's own voxel is
/// free those around it become candidates now: with a radius all, as a line that keeps it cuts no corner; without one
/// only those whose closed cubes hold the point as well, on their common face, edge or corner. A point that `moves` may
/// have come through a corner, and returns through it.
bool join_others(Join& join, const Grid& grid, const Vec3& point, bool moves) noexcept;

/// Checks the line to the next candidate, which has to be clear of `fences`, too (null: none); only while kTrying.
void join_try(Join& join, const Grid& grid, const Fences* fences, const Vec3& point) noexcept;

}  // namespace tern

#endif
