// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_ELLIPSOID_INSCRIBE_HPP
#define TERN_ELLIPSOID_INSCRIBE_HPP

#include "ellipsoid/ellipsoid_metric.hpp"
#include "tern/corridor.hpp"

namespace tern {

/// Shrinks a segment's ellipsoid until it lies inside every half-space. y and z shrink by the same factor. x stays,
/// because every half-space contains the segment that x spans. The ball of a hover (`ball`) shrinks as a whole. If a
/// half-space touches the segment, a sliver remains: kSliver of the longest semi-axis, so that the matrix stays
/// positive definite.
void inscribe(const Polyhedron& polyhedron, bool ball, EllipsoidFrame& frame) noexcept;

}  // namespace tern

#endif
