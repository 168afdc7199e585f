// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Limits on velocity, acceleration or jerk as half-spaces that a quadratic programme takes.
#ifndef TERN_TRAJECTORY_LIMIT_PLANES_HPP
#define TERN_TRAJECTORY_LIMIT_PLANES_HPP

#include "base/bounds.hpp"
#include "tern/corridor.hpp"

namespace tern {

/// Sides of the regular polygon that stands for a limit on the horizontal norm. It lies inside the circle: a direction
/// half-way between two corners loses 1 - cos(pi / 16), 1.92 %. A direction at a corner loses nothing.
constexpr int kHorizontalSides = 16;
constexpr double kPolygonInside = 0.98078528040323043;  ///< cos(pi / 16): its inscribed circle's radius
constexpr int kMaxLimitPlanes = 6 + kHorizontalSides;

/// Part of a limit that its constraints leave free, so that a solution to within the solver's tolerance keeps the
/// limit.
constexpr double kConstraintMargin = 1e-8;

/// The half-spaces, for values divided by `unit`, the smallest limit. Constraints then have values of the same size as
/// positions in metres.
struct LimitPlanes {
  double unit;
  int count;
  Halfspace planes[kMaxLimitPlanes];
};

/// The horizontal unit vector along the value; along x if there is none.
Vec3 horizontal_direction(const Vec3& along) noexcept;
/// The outward normal of a side, 0 .. kHorizontalSides - 1, of the polygon with a corner in the horizontal direction
/// `corner`, which is a unit vector.
Vec3 polygon_normal(const Vec3& corner, int side) noexcept;

/// The half-spaces of the limits: first both sides of every axis, without those that are unlimited or that the
/// horizontal limit implies; then the polygon. The polygon has a corner in the horizontal direction of `along`, which
/// may have any length; if that is zero, along x. The same bounds give the same number of planes. At least one limit
/// must exist. `margin`: the part of the limits that is left free.
LimitPlanes limit_planes(const Bounds& bounds, const Vec3& along, double margin = kConstraintMargin) noexcept;

}  // namespace tern

#endif
