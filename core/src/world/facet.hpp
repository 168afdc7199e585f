// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A facet of a polyhedron: the polygon that remains of one plane after the other planes have cut it.
#ifndef TERN_WORLD_FACET_HPP
#define TERN_WORLD_FACET_HPP

#include "base/linear.hpp"
#include "tern/config.hpp"
#include "tern/halfspace.hpp"
#include "tern/vec3.hpp"
#include "world/solids.hpp"

namespace tern {

/// The most cuts of one facet: by all planes of a corridor's polyhedron, or by those of a solid and of the box around
/// it.
constexpr int kMaxCuts = kMaxPlanes > kMaxSolidFaces + kBoxPlanes ? kMaxPlanes : kMaxSolidFaces + kBoxPlanes;

/// A convex polygon in a plane, corners in order around it. Each cut adds one corner at most.
struct Facet {
  Vec3 foot;  ///< the plane's point nearest to the frame's origin
  Vec3 u;     ///< two unit vectors in the plane, at right angles
  Vec3 v;
  int count;
  Vector2 corner[kMaxCuts + 4];  ///< corner k is foot + corner[k][0] u + corner[k][1] v
};

/// A square on the plane, centred on its foot. `reach` is half its edge, in metres, > 0.
Facet square_on(const Halfspace& plane, double reach) noexcept;

/// Cuts off the part of the facet outside the half-space, if a corner is more than `slack` metres outside. False if
/// nothing is left. Removes no point of the facet that is inside the half-space by more than the rounding error,
/// 2.2e-15 of the facet's reach.
bool cut(const Halfspace& by, Facet& facet, double slack = 0.0) noexcept;

}  // namespace tern

#endif
