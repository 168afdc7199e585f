// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A polyhedron that holds the leg beside its own serves it too: the flight need not turn at the waypoint between the
// two, and for a later leg nothing is built. It is convex: where it holds() its segment and the other end of the leg
// beside it, it holds that leg.
#ifndef TERN_CORRIDOR_REUSE_HPP
#define TERN_CORRIDOR_REUSE_HPP

#include "base/polyhedron.hpp"
#include "tern/corridor.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Makes the polyhedron that of the segment from `from` to `to`, which it must hold. Its half-spaces stay; the
/// ellipsoid becomes a round one along the new segment, inscribed as that of the old one was; it stays where the new
/// one is a point, a way back to where it began.
void set_segment(Polyhedron& polyhedron, const Vec3& from, const Vec3& to) noexcept;

}  // namespace tern

#endif
