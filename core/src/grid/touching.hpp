// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A segment that touches a box. The closest pair then does not tell on which side of the box the segment lies.
#ifndef TERN_GRID_TOUCHING_HPP
#define TERN_GRID_TOUCHING_HPP

#include "tern/grid.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// The minimum of normal . p over the closed box, taken at the corner that the normal points away from.
inline double support(const Vec3& normal, const Box& box) noexcept {
  const double x = normal.x * (normal.x < 0.0 ? box.upper.x : box.lower.x);
  const double y = normal.y * (normal.y < 0.0 ? box.upper.y : box.lower.y);
  const double z = normal.z * (normal.z < 0.0 ? box.upper.z : box.lower.z);
  return (x + y) + z;
}

/// How far the box lies beyond the segment along a normal, in units of the normal's length; negative if they overlap
/// along it.
double room_along(const Vec3& from, const Vec3& to, const Box& box, const Vec3& normal) noexcept;

/// A unit normal and the room along it.
struct WidestNormal {
  Vec3 normal;
  double room;
};

/// Takes a unit normal in place of the best one if it leaves more room.
void offer(const Vec3& from, const Vec3& to, const Box& box, const Vec3& unit, WidestNormal& best) noexcept;

/// The best separating axis of a segment that touches the box: the one with the most room. The candidates are the box's
/// face normals and the cross products of its edges with the segment. A face wins a tie. Ignores products shorter than
/// `direction` (direction_tolerance): there, the segment runs along the edge, or is a point.
WidestNormal separating_normal(const Vec3& from, const Vec3& to, const Box& box, double direction) noexcept;

}  // namespace tern

#endif
