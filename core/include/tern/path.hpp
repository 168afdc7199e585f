// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PATH_HPP
#define TERN_PATH_HPP

#include "tern/config.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// The path through free space (the paper's Section 3.2), before and after it is shortened. All points are in the
/// grid's local frame (world minus grid origin), in metres. Both chains begin at the exact start and end at the exact
/// goal, not at voxel centres. Planner::path() returns it, for displays and logs.
struct Path {
  /// Points of the jump-point path, 2 .. kMaxJumpPoints.
  int raw_count;
  /// The jump-point path: the start, the centres of the voxels where the path turns, the goal.
  Vec3 raw[kMaxJumpPoints];
  /// Length of the jump-point path, metres.
  double raw_length;
  /// Cost of the path that the search found between the voxels of start and goal, in voxel edges: 1, sqrt 2 or sqrt 3
  /// per step. With SearchMode::kOptimal it is the least cost on the grid. 0 if start and goal share a voxel.
  double grid_length;
  /// Waypoints of the shortened path, 2 .. kMaxWaypoints.
  int count;
  /// The waypoints. Two neighbours are joined by a leg, a straight line through free space.
  Vec3 points[kMaxWaypoints];
  /// Length of the shortened path, metres.
  double length;
};

}  // namespace tern

#endif
