// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A polyhedron that contains a neighbouring leg serves that leg too. The flight then need not turn at the waypoint
// between the two legs, and a later leg needs no polyhedron of its own.
#ifndef TERN_CORRIDOR_REUSE_HPP
#define TERN_CORRIDOR_REUSE_HPP

#include "base/polyhedron.hpp"
#include "tern/corridor.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Gives the polyhedron a new line, from `from` to `to`, which it must contain. The half-spaces stay. The ellipsoid
/// becomes a round one along the new line, inscribed again. If the new line is a point, because the path came back to
/// where it began, the old ellipsoid stays.
void set_segment(Polyhedron& polyhedron, const Vec3& from, const Vec3& to) noexcept;

}  // namespace tern

#endif
