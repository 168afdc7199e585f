// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The points of a programme: weighted sums of a segment's control points as affine functions of the unknowns.
#ifndef TERN_TRAJECTORY_PROGRAMME_POINTS_HPP
#define TERN_TRAJECTORY_PROGRAMME_POINTS_HPP

#include "qp/qp.hpp"
#include "trajectory/end_weights.hpp"
#include "trajectory/piece.hpp"
#include "trajectory/programme.hpp"

namespace tern {

/// Appends a point times the multiplier, unless the point is constant. True if it was appended.
bool add_point(const Piece& piece, const EndWeights& weights, double multiplier, const PointOrigin& origin,
               ProgrammeScale& scale, QpProblem& problem) noexcept;

/// Appends a group of the points from `point_begin` on, unless there are none.
void add_group(int point_begin, int plane_begin, int plane_end, QpProblem& problem) noexcept;

}  // namespace tern

#endif
