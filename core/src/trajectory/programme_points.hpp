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

/// drift[k] = T dc_k/dT, with the states at both ends fixed. For c_k = sum_j kFirstEnd[k][j] T^j d_j this is k (c_k -
/// c_(k - 1)). The control points next to the second end follow in the same way, counted from that end.
void drift_of(const Vec3* points, Vec3* drift) noexcept;

}  // namespace tern

#endif
