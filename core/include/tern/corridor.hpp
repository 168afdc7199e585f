// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The safe flight corridor (the paper's Section 3.3.1): convex polyhedra along the path. Everything here is in the
// grid's local frame (world minus grid origin), in metres. Planner::corridor() returns it, for displays and logs.
#ifndef TERN_CORRIDOR_HPP
#define TERN_CORRIDOR_HPP

#include "tern/config.hpp"
#include "tern/halfspace.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// A convex polyhedron for the robot's centre. Every point of it keeps the grid's radius from every obstacle voxel.
struct Polyhedron {
  /// Half-spaces that bound the polyhedron, at most kMaxPlanes.
  int count;
  /// Normals of length 1. None of the half-spaces is redundant: each cuts something off that the others leave.
  Halfspace planes[kMaxPlanes];
  /// Start of the straight line that this polyhedron was made for. Inside the polyhedron.
  Vec3 from;
  /// End of that line. Inside the polyhedron. The line is a leg of the path, a piece of a long leg, or a shortcut past
  /// several legs that the polyhedron also contains.
  Vec3 to;
};

/// The polyhedra in flight order, along the path. The line of polyhedron i ends where the line of polyhedron i + 1
/// begins. A stop before or after the path has no polyhedron.
struct Corridor {
  /// 1 .. kMaxSegments.
  int count;
  Polyhedron polyhedra[kMaxSegments];
};

}  // namespace tern

#endif
