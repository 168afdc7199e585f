// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Operations of the solver's steps (see base/work.hpp), from the current sizes.
#ifndef TERN_QP_OPERATIONS_HPP
#define TERN_QP_OPERATIONS_HPP

#include "base/work.hpp"
#include "qp/solver.hpp"

namespace tern::qp {

/// The three coordinates of a point: its terms on each axis.
constexpr Operations kPointOperations = ops::kMultiplyAdd * kQpAxes * kQpPointTerms;
/// An active constraint: its point and its violation, or its part of A'y.
constexpr Operations kConstraintOperations = kPointOperations + ops::kDot;

/// A substitution with the band of the Hessian's factor, for all unknowns.
inline Operations band_operations(const QpSolver& solver) {
  return ops::kMultiplyAdd * kQpAxes * (kQpBand + 1) * solver.unknowns;
}

/// A pass over the basis: a projection on it, or a combination of its columns.
inline Operations basis_operations(const QpSolver& solver) {
  return ops::kPiece + ops::kElement * solver.active_count * solver.stride;
}

/// A substitution with the triangle of the active constraints, half of a square.
inline Operations triangle_operations(const QpSolver& solver) {
  return ops::kElement * solver.active_count * (solver.active_count + 1) / 2 + ops::kTurn * solver.active_count;
}

/// Rotations that take out constraint j of the active ones. Each mixes two elements of two columns.
inline Operations rotation_operations(const QpSolver& solver, int j) {
  const int later = solver.active_count - 1 - j;
  return ops::kPiece + 2 * ops::kElement * later * (solver.stride + solver.active_count);
}

/// The residuals of an answer: the Hessian's two bands and the gradients, and each active constraint twice.
inline Operations measure_operations(const QpSolver& solver) {
  return 4 * band_operations(solver) + 2 * kConstraintOperations * (solver.active_count + 1);
}

/// A price of a batch of points, or of one point, against `planes` half-spaces.
inline Operations price_operations(bool alone, int planes) {
  if (alone) return 2 * ops::kPiece + kPointOperations + ops::kDot * planes;
  return ops::kPiece + kQpBatch * (kPointOperations + ops::kElement * kQpAxes * planes);
}

/// The beginning of a solve.
inline Operations begin_operations(const QpProblem& problem) {
  return ops::kMultiplyAdd * kQpAxes * kQpBand * 2 * problem.unknowns + ops::kTurn * problem.point_count +
         2 * ops::kDot * problem.plane_count + 2 * ops::kRow * problem.group_count;
}

}  // namespace tern::qp

#endif
