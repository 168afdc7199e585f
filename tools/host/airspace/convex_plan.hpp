// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Convex outlines in plan: hulls, half-planes of pieces, and what of them matters in a box.
#ifndef TERN_HOST_AIRSPACE_CONVEX_PLAN_HPP
#define TERN_HOST_AIRSPACE_CONVEX_PLAN_HPP

#include <vector>

#include "host/airspace/convex_pieces.hpp"
#include "host/airspace/zone_heights.hpp"
#include "tern/halfspace.hpp"

namespace tern_host {

/// The convex hull of corners, counter-clockwise, without corners on its sides. Exact.
std::vector<Corner> hull_of(std::vector<Corner> corners);

/// A convex polygon of counter-clockwise corners as a piece.
ConvexPiece piece_of(const std::vector<Corner>& corners);

/// The polygon with at most `most` corners within a convex polygon that is left when the flattest corners go first.
/// `lost`: how far a corner that went is from what is left, metres, at most.
std::vector<Corner> fewer_corners(const std::vector<Corner>& corners, std::size_t most, double& lost);

/// How far the point is beyond the side, metres; negative within.
double beyond(const Side& side, const ConvexPiece::Vertex& point);

/// True if a corner of an outline is deeper in the hull of them all: then so is a part of the hull that is not theirs,
/// but for outlines that go back along themselves.
bool has_corner_deeper(const std::vector<Outline>& outlines, double depth, const ConvexPiece& hull);

/// All of the piece is within so many metres of one of the convex polygon's sides.
double depth_within(const ConvexPiece& piece, const ConvexPiece& polygon);

/// False if the piece is more than `by` away from the box.
bool reaches(const ConvexPiece& piece, const PlanBox& box, double by);

/// Upright half-spaces that hold everything within `by` metres of the piece and nothing farther away than 2 `by`: sides
/// are moved, and sharp corners cut off. A negative `by` moves them inwards. Those that hold all of the box are left
/// out.
std::vector<tern::Halfspace> upright_planes(const ConvexPiece& piece, double by, const PlanBox& box);

}  // namespace tern_host

#endif
