// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds which half-spaces bound a polyhedron, and which are redundant because the others imply them. A redundant one
// would cost the quadratic programme eight useless rows per segment.
#ifndef TERN_CORRIDOR_REDUNDANCY_HPP
#define TERN_CORRIDOR_REDUNDANCY_HPP

#include "tern/corridor.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// A half-space is redundant if it cuts off only a sliver thinner than this, as a share of the polyhedron's reach. This
/// is some thousand times the rounding of the arithmetic here, and a hundred thousandth of the check's tolerance.
constexpr double kSliverThickness = 1e-12;

/// Drops the redundant half-spaces of a bounded polyhedron; the others keep their order. `inside` is a point of the
/// polyhedron, and every other point of it lies within `reach` (metres) of `inside`. Each half-space dropped lets the
/// polyhedron grow by kSliverThickness * reach at most. By the same measure, none of the others is redundant. If the
/// polyhedron is so flat that `inside` is on a plane, all half-spaces stay. Each half-space's facet is a convex polygon
/// that all others cut: at most kMaxPlanes^2 cuts of polygons with kMaxPlanes + 4 corners. `scratch` has room for
/// `count` half-spaces. Returns how many cuts it made.
int drop_redundant(Polyhedron& polyhedron, const Vec3& inside, double reach, Halfspace* scratch) noexcept;

}  // namespace tern

#endif
