// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_ELLIPSOID_INSCRIBE_HPP
#define TERN_ELLIPSOID_INSCRIBE_HPP

#include "ellipsoid/ellipsoid_metric.hpp"
#include "tern/corridor.hpp"

namespace tern {

/// Shrinks a segment's ellipsoid until it lies inside every half-space: y and z by one factor, x not at all, because
/// every half-space holds the segment that x spans. A hover's ball (`ball`) shrinks as a whole. Where a half-space
/// touches the segment a sliver of kSliver of the longest semi-axis remains, so that the axes stay positive definite.
void inscribe(const Polyhedron& polyhedron, bool ball, EllipsoidFrame& frame) noexcept;

}  // namespace tern

#endif
