// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A polyhedron that already holds the next leg serves it too: nothing is built for that leg, and the flight need not
// turn at the waypoint between the two.
#ifndef TERN_CORRIDOR_REUSE_HPP
#define TERN_CORRIDOR_REUSE_HPP

#include "tern/corridor.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// True where every half-space keeps `margin` (metres, >= 0) from `point`. The polyhedron is convex: one that holds its
/// segment's end and the end of the next leg holds the leg.
bool holds(const Polyhedron& polyhedron, const Vec3& point, double margin) noexcept;

/// Makes the polyhedron that of the segment from its `from` to `point`, which it must hold. Its half-spaces stay; the
/// ellipsoid becomes a round one along the new segment, inscribed as that of the old one was.
void extend_segment(Polyhedron& polyhedron, const Vec3& point) noexcept;

}  // namespace tern

#endif
