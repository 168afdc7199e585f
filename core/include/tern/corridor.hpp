// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_CORRIDOR_HPP
#define TERN_CORRIDOR_HPP

#include "tern/config.hpp"
#include "tern/halfspace.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// The ellipsoid { axes * q + center : |q| <= 1 } of the paper's Section 3.3.1, axes symmetric positive definite.
struct Ellipsoid {
  double axes[3][3];
  Vec3 center;
};

/// A convex polyhedron for the robot's centre: every point of it keeps the radius from every obstacle voxel.
struct Polyhedron {
  int count;      ///< half-spaces that bound it, none of them redundant
  int redundant;  ///< half-spaces behind those that follow from them, but cut off some obstacle all alone: with them
                  ///< a plane an obstacle proves the polyhedron clear
  Halfspace planes[kMaxPlanes];
  Ellipsoid ellipsoid;
  Vec3 from;  ///< its segment, both ends inside: the leg that it was grown around, or on to the end of a later leg
  Vec3 to;    ///< that it holds as well
};

/// Half-spaces of a polyhedron, redundant ones included.
inline int all_planes(const Polyhedron& polyhedron) noexcept {
  return polyhedron.count + polyhedron.redundant;
}

/// One polyhedron a segment, in flight order; polyhedron i ends where i + 1 begins.
struct Corridor {
  int count;
  Polyhedron polyhedra[kMaxSegments];
};

}  // namespace tern

#endif
