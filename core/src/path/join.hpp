// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Connects the exact start or goal to a free voxel of the grid.
#ifndef TERN_PATH_JOIN_HPP
#define TERN_PATH_JOIN_HPP

#include <cstdint>

#include "base/work.hpp"
#include "tern/grid.hpp"
#include "world/world.hpp"

namespace tern {

/// A point joins the centre of a free voxel at most this many voxels away from the point's own on each axis.
constexpr int kJoinReach = 2;
constexpr int kJoinWidth = 2 * kJoinReach + 1;
constexpr int kJoinCells = kJoinWidth * kJoinWidth * kJoinWidth;
constexpr int kMaxJoins = kJoinCells - 1;

enum class JoinState : std::uint8_t {
  kJoined,   ///< `voxel` is free, and the line from the point to its centre is clear
  kTrying,   ///< candidates are left
  kRefused,  ///< the point is too close to an obstacle, or no line to a free voxel near it is clear
};

/// The state of joining one end of the query to the grid. Plain data; needs no initialisation before join_begin.
struct Join {
  JoinState state;
  Voxel voxel;
  Voxel home;  ///< the point's own voxel
  std::int32_t count;
  std::int32_t next;
  Voxel candidates[kMaxJoins];  ///< free voxels: nearest centre first, ties by least z, y, x
  bool searched[kJoinCells];    ///< voxels around home, x fastest: true if a search from there found no path
};

/// Operations of join_begin(), which examines the voxels within reach, and sorts those that are free.
inline Operations join_operations(const Join& join) noexcept {
  return join.count > 0 ? ops::kRow * kJoinCells + ops::kTurn * join.count * join.count : ops::kTurn * kJoinCells;
}
/// Operations of finding the voxels within reach that a search has reached, each from its six neighbours.
constexpr Operations kSearchedOperations = 6 * ops::kRow * kJoinCells;

/// A point in a free voxel is joined at once. If the voxel is not free but the point keeps the radius, the free voxels
/// around it are the candidates. Where a wall runs along voxels' faces, a point on it belongs to the voxel inside.
void join_begin(Join& join, const World& world, const Vec3& point) noexcept;

/// Call this if the search from `voxel` found no path: the voxel may lie in a pocket that is cut off. Voxels within
/// reach that are connected to it through faces are not tried again. False if no candidate is left. If the point's own
/// voxel is free, the voxels around it become candidates now. With a radius, these are all free ones, because a line
/// that keeps the radius cuts no corner. Without a radius, they are only those whose closed cubes also contain the
/// point, on a common face, edge or corner. If the point `moves`, all free voxels are candidates even without a radius:
/// the point may have come through a corner, and may go back through it.
bool join_others(Join& join, const Grid& grid, const Vec3& point, bool moves) noexcept;

/// Checks the line to the next candidate. Call only while kTrying. A piece of work.
void join_try(Join& join, const World& world, const Vec3& point, Work& work) noexcept;

}  // namespace tern

#endif
