// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Proves that the hull of a few points keeps a distance from every obstacle cube, if it gets normals along which the
// obstacles are cut off. It reads whole rows of voxels at once, so it is fast, and a long curve needs no halving. The
// normals need no trust: each gives the plane through the hull's own furthest point. A wrong one cuts nothing off.
#ifndef TERN_PROVE_CUT_OFF_HPP
#define TERN_PROVE_CUT_OFF_HPP

#include <cstdint>

#include "tern/corridor.hpp"
#include "tern/grid.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Half-spaces whose normals may cut obstacles off. Their offsets do not matter.
struct Hints {
  const Halfspace* planes;
  int count;  ///< for cut_off(), at most kMaxPlanes
};

/// The hints that a polyhedron gives; none if its count is out of range.
Hints hints_of(const Polyhedron& polyhedron) noexcept;

/// True if a normal of a hint is a unit vector, within rounding.
bool is_unit(const Vec3& normal) noexcept;

/// The greatest of normal . point.
double support_of(const Vec3& normal, const Vec3* points, int count) noexcept;

/// Rows of y times rows of z that a hull may extend over. Larger ones are not looked at.
constexpr int kMostRows = 1 << 14;

/// True only if each obstacle cube is cut off from the hull of the points by `distance`, along an axis or along the
/// normal of a hint. Local frame, metres. `distance` may be negative: by so much the hull may be inside a cube.
bool cut_off(const Grid& grid, const Vec3* points, int count, const Hints& hints, double distance, Work& work) noexcept;

}  // namespace tern

#endif
