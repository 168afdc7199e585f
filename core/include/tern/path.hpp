// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PATH_HPP
#define TERN_PATH_HPP

#include "tern/config.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// What the front end found. Local frame (world minus grid origin), metres. Both chains begin at the exact
/// start and end at the exact goal.
struct Path {
  int raw_count;               ///< points of the jump-point path
  Vec3 raw[kMaxJumpPoints];    ///< start, voxel centres of jump points, goal
  double raw_length;           ///< length of that chain, metres
  double grid_length;          ///< optimal cost between the two end voxels, in voxels (1, sqrt 2, sqrt 3 a step)
  int count;                   ///< waypoints after the shortcut, 2 at least
  Vec3 points[kMaxWaypoints];  ///< the shortcut path
  double length;               ///< its length, metres
};

}  // namespace tern

#endif
