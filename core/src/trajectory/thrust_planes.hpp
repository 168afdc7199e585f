// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Limits of thrust and tilt as half-spaces that a quadratic programme takes: a polyhedron inside the ball and the cone
// of base/bounds.hpp.
#ifndef TERN_TRAJECTORY_THRUST_PLANES_HPP
#define TERN_TRAJECTORY_THRUST_PLANES_HPP

#include "base/bounds.hpp"
#include "qp/qp.hpp"
#include "tern/corridor.hpp"
#include "trajectory/limit_planes.hpp"

namespace tern {

/// The ball's polyhedron has rings of kHorizontalSides faces each, one for each kHorizontalSides-th of a turn of the
/// tilt. A direction between two corners loses 1 - cos(pi / 16), 1.92 %, along a ring and across it, one at a corner
/// nothing.
constexpr int kMostRings = 6;
/// The cone's sides and the rings.
constexpr int kMaxThrustPlanes = kHorizontalSides + kMostRings * kHorizontalSides;
static_assert(kMaxThrustPlanes == kQpThrustPlanes, "room in a programme");

/// Writes the half-spaces for accelerations divided by `unit`, and returns their number, at most kMaxThrustPlanes. The
/// polyhedron has a corner in the direction of the thrust at the acceleration `along`. Rings that other bounds cut off
/// are left out. The same arguments but `along` may give another number.
int thrust_planes(const Bounds& bounds, const Vec3& along, double unit, Halfspace* planes) noexcept;

}  // namespace tern

#endif
