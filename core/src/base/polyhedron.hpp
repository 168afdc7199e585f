// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a point is in a polyhedron. `count` half-spaces count; redundant ones say nothing more.
#ifndef TERN_BASE_POLYHEDRON_HPP
#define TERN_BASE_POLYHEDRON_HPP

#include "tern/corridor.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// True where every half-space keeps `margin` metres from `point`; a negative margin lets the point lie that far
/// outside.
bool holds(const Polyhedron& polyhedron, const Vec3& point, double margin) noexcept;

/// Metres from `point` to the nearest half-space's plane, negative outside; count >= 1.
double room_at(const Polyhedron& polyhedron, const Vec3& point) noexcept;

}  // namespace tern

#endif
