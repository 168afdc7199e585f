// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The position of a point relative to a polyhedron.
#ifndef TERN_BASE_POLYHEDRON_HPP
#define TERN_BASE_POLYHEDRON_HPP

#include "tern/corridor.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// True if `point` is at least `margin` metres inside every half-space. A negative margin lets the point lie that far
/// outside.
bool holds(const Polyhedron& polyhedron, const Vec3& point, double margin) noexcept;

/// Metres from `point` to the nearest plane of a half-space, negative outside the polyhedron. The polyhedron must have
/// at least one half-space.
double room_at(const Polyhedron& polyhedron, const Vec3& point) noexcept;

}  // namespace tern

#endif
