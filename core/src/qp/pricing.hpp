// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Chooses the row that enters: the one that is violated most, measured as a distance in the metric of the Hessian. That
// is violation / |L^-1 a|. With unit normals, the divisor depends only on the row's point.
#ifndef TERN_QP_PRICING_HPP
#define TERN_QP_PRICING_HPP

#include "qp/rows.hpp"

namespace tern::qp {

/// A violated row; `found` is false if there is none.
struct Candidate {
  bool found;
  bool constant;  ///< the row depends on no unknown: nothing can be done about it
  QpRow row;
  double violation;  ///< of the unit row
};

/// Forgets the lengths of the points. Call it if coefficients or Hessian changed.
void forget_lengths(const QpProblem& problem, QpSolver& solver);

/// Forgets which rows were violated. Call it if the point has jumped or the right-hand sides changed.
void forget_scans(QpSolver& solver);

/// The row to enter at solver.x: the best of those priced that are violated by more than kQpEntering. Ties go to the
/// lowest group, then point, then plane. If none is found, every row was priced, and solver.worst is the largest
/// violation.
Candidate price(const QpProblem& problem, QpSolver& solver);

}  // namespace tern::qp

#endif
