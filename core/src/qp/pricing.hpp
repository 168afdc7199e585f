// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which row enters: the one that is violated most, measured as a distance in the metric of the Hessian. That is
// violation / |L^-1 a|, and the second factor belongs to a row's point alone once normals are unit.
#ifndef TERN_QP_PRICING_HPP
#define TERN_QP_PRICING_HPP

#include "qp/rows.hpp"

namespace tern::qp {

/// A violated row, `found` where there is one.
struct Candidate {
  bool found;
  bool constant;  ///< no unknown moves the row: nothing can be done about it
  QpRow row;
  double violation;  ///< of the unit row
};

/// Forgets the points' lengths: coefficients or Hessian changed.
void forget_lengths(const QpProblem& problem, QpSolver& solver);

/// Forgets which rows were violated: the point has jumped, or the right-hand sides changed.
void forget_scans(QpSolver& solver);

/// A row to enter at solver.x, violated by more than kQpEntering: the best of those looked at; ties go to the lowest
/// group, then point, then plane. Where none is found every row was looked at, and solver.worst is the largest
/// violation.
Candidate price(const QpProblem& problem, QpSolver& solver);

}  // namespace tern::qp

#endif
