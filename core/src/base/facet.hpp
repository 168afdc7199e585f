// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A facet of a polyhedron: the polygon that is left of one plane when the others have cut it.
#ifndef TERN_BASE_FACET_HPP
#define TERN_BASE_FACET_HPP

#include "base/linear.hpp"
#include "tern/config.hpp"
#include "tern/halfspace.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Cuts that one facet may go through: by all planes of a corridor's polyhedron, or of a fence and the box around it.
constexpr int kMaxCuts = kMaxPlanes > kMaxFencePlanes + 6 ? kMaxPlanes : kMaxFencePlanes + 6;

/// A convex polygon in a plane, corners in order around it. Each cut adds one corner at most.
struct Facet {
  Vec3 foot;  ///< the plane's point nearest to the frame's origin
  Vec3 u;     ///< two unit vectors in the plane, at right angles
  Vec3 v;
  int count;
  Vector2 corner[kMaxCuts + 4];  ///< corner k is foot + corner[k][0] u + corner[k][1] v
};

/// The square of half edge `reach` (metres, > 0) on the plane, about its foot.
Facet square_on(const Halfspace& plane, double reach) noexcept;

/// Cuts off what lies beyond the half-space, where anything does by more than `slack` metres. False where nothing is
/// left. But for rounding, 2.2e-15 of the facet's reach, it takes no point of the facet that is in the half-space.
bool cut(const Halfspace& by, Facet& facet, double slack = 0.0) noexcept;

}  // namespace tern

#endif
