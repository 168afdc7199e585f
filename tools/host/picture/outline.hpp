// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_PICTURE_OUTLINE_HPP
#define TERN_HOST_PICTURE_OUTLINE_HPP

#include <vector>

#include "host/picture/canvas.hpp"
#include "tern/halfspace.hpp"

namespace tern_host {

/// The corners of the bounded polyhedron that unit half-spaces share: where three planes meet inside all others.
/// Corners where more planes meet appear more than once.
std::vector<tern::Vec3> vertices(const std::vector<tern::Halfspace>& planes);

/// The convex hull of points of the plane, counter-clockwise from the leftmost (y upwards); empty for fewer than three.
std::vector<Pixel> convex_hull(std::vector<Pixel> points);

}  // namespace tern_host

#endif
