// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_INTENT_CONVEX_GAP_HPP
#define TERN_HOST_INTENT_CONVEX_GAP_HPP

#include <vector>

#include "host/airspace/convex_pieces.hpp"

namespace tern_host {

/// Corners of a convex polygon in plan, counter-clockwise, metres.
using PlanPolygon = std::vector<ConvexPiece::Vertex>;

/// How far apart two polygons are; 0 where they have a point in common.
double gap_between(const PlanPolygon& a, const PlanPolygon& b);

/// A point of both polygons, in the middle of the corners of what they have in common; where they are apart, halfway
/// between the nearest points.
ConvexPiece::Vertex common_place(const PlanPolygon& a, const PlanPolygon& b);

}  // namespace tern_host

#endif
