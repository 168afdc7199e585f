// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which half-spaces bound a polyhedron and which say nothing that the others do not. A redundant one costs the
// quadratic programme eight rows a segment for nothing.
#ifndef TERN_CORRIDOR_REDUNDANCY_HPP
#define TERN_CORRIDOR_REDUNDANCY_HPP

#include "tern/corridor.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// A half-space that cuts off a sliver thinner than this, in parts of the polyhedron's reach, is redundant: some
/// thousand times the rounding of the arithmetic that decides, and a hundred thousandth of what the check forgives.
constexpr double kSliverThickness = 1e-12;

/// Moves the redundant half-spaces of the bounded polyhedron behind the others, both in their old order, and sets
/// `count` and `redundant`. The set stays what it was, to kSliverThickness of `reach` for each that moves; none of the
/// first `count` is redundant any more, by the same measure. Every point of the polyhedron lies within `reach` (metres)
/// of `inside`, a point of it. A polyhedron as flat as that, where `inside` is on a plane, keeps all. Each half-space's
/// facet is a convex polygon cut by all others: at most kMaxPlanes^2 cuts of polygons with kMaxPlanes + 4 corners.
/// `scratch` has room for `count` half-spaces.
void set_redundant_aside(Polyhedron& polyhedron, const Vec3& inside, double reach, Halfspace* scratch) noexcept;

}  // namespace tern

#endif
