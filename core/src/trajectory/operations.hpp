// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Operations of the trajectory stage besides those of the solver (see base/work.hpp).
#ifndef TERN_TRAJECTORY_OPERATIONS_HPP
#define TERN_TRAJECTORY_OPERATIONS_HPP

#include "base/work.hpp"
#include "qp/qp.hpp"
#include "times/chain.hpp"

namespace tern {

/// A duration tried for a segment at an end: its curve and three derivatives, against half-spaces and limits.
constexpr Operations kEndOperations = 10 * ops::kCurve;

/// The assembly of a programme, and the snap of the chain with all unknowns zero: eight curves a segment, and each
/// point and half-space once.
inline Operations assembly_operations(const Chain& chain, const QpProblem& problem) {
  return 8 * ops::kCurve * chain.count + kQpPointTerms * ops::kDot * problem.point_count +
         ops::kDot * problem.plane_count;
}

/// A judgement, whatever it decides: the chain's durations, tried and kept.
inline Operations judgement_operations(const Chain& chain) {
  return ops::kPiece + ops::kCurve * chain.count;
}

/// The points of a solution, read and checked against polyhedra and limits: ten curves a segment.
inline Operations points_operations(const Chain& chain) {
  return 10 * ops::kCurve * chain.count;
}

/// The prices of the durations: five curves a segment, and two points for each active row.
inline Operations prices_operations(const Chain& chain, const QpSolution& solution) {
  return 5 * ops::kCurve * chain.count + 2 * ops::kPiece * solution.active_count;
}

/// Brakings that stop-and-go tries at an end in motion, about.
constexpr int kBrakingsTried = 256;

/// Stop-and-go along `polyhedra` polyhedra: a curve each, and at ends in motion one for each braking that is tried.
inline Operations rest_operations(int polyhedra, bool at_rest) {
  return ops::kCurve * (polyhedra + (at_rest ? 0 : kBrakingsTried));
}

}  // namespace tern

#endif
